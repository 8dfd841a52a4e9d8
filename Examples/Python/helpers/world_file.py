"""World files: six lines that say where the pixels of a map lie."""


def write_world_file(image, name):
    """Beside a picture of a vtkImageData whose points have coordinates on a map: .pgw beside .png,
    .tfw beside .tif. Pictures begin with the top row, images with the bottom one."""
    (across, up, _), (left, bottom, _) = image.GetSpacing(), image.GetOrigin()
    top = bottom + up * (image.GetDimensions()[1] - 1)
    with open(name, "w", encoding="ascii") as file:
        file.write("".join(f"{value!r}\n" for value in (across, 0.0, 0.0, -up, left, top)))
