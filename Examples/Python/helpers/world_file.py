"""World files: six lines that say where the pixels of a map lie."""


def write_world_file(image, name, central_longitude=0.0):
    """Beside a picture of a vtkImageData whose points have coordinates on a map: .pgw beside .png,
    .tfw beside .tif. Pictures begin with the top row, images with the bottom one.

    central_longitude: that of an Equirectangular map of vtkBodyMapImage, whose coordinates are
    degrees from its central meridian.
    """
    (across, up, _), (left, bottom, _) = image.GetSpacing(), image.GetOrigin()
    top = bottom + up * (image.GetDimensions()[1] - 1)
    with open(name, "w", encoding="ascii") as file:
        file.write("".join(f"{value!r}\n" for value in (across, 0.0, 0.0, -up, left + central_longitude, top)))
