"""Write closed surfaces as 3MF, the format of programs for 3D printers, in millimeters."""
import io
import zipfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData

from conformalsom.triangles import triangles_of

DATE = (1980, 1, 1, 0, 0, 0)  # of all parts, so that equal surfaces have equal files
MODEL = "3D/3dmodel.model"
TYPES = """<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""
RELATIONS = f"""<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/{MODEL}" Id="model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"""
BEGIN = """<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">ConformalSOM</metadata>
<resources><object id="1" type="model"><mesh><vertices>
"""
MIDDLE = "</vertices><triangles>\n"
END = """</triangles></mesh></object></resources>
<build><item objectid="1"/></build>
</model>
"""


def model_of(points, triangles):
    """The model as XML: points in millimeters, triangles counter-clockwise seen from outside."""
    text = io.StringIO()
    text.write(BEGIN)
    text.writelines(f'<vertex x="{x}" y="{y}" z="{z}"/>\n' for x, y, z in points.astype(np.float32).astype(str))
    text.write(MIDDLE)
    text.writelines(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>\n' for a, b, c in triangles.tolist())
    text.write(END)
    return text.getvalue()


class ThreeMFWriter(VTKPythonAlgorithmBase):
    """Writes a surface of triangles whose coordinates are millimeters."""

    def __init__(self):
        super().__init__(nInputPorts=1, inputType="vtkPolyData", nOutputPorts=0)
        self.path = ""
        self.problem = None

    def SetInputData(self, surface):  # pylint: disable=invalid-name
        """Set the surface."""
        self.SetInputDataObject(surface)

    def SetFileName(self, path):  # pylint: disable=invalid-name
        """Set the file to write."""
        self.path = path

    def Write(self):  # pylint: disable=invalid-name
        """Write the file. Raises OSError, with the name of the file, or MemoryError if this fails."""
        self.problem = None
        self.Modified()
        self.Update()
        if self.problem is not None:
            raise self.problem

    def RequestData(self, _request, inputs, _outputs):  # pylint: disable=invalid-name
        """Write the file of the current input, and keep an error, which VTK would drop."""
        try:
            self.write_file(vtkPolyData.GetData(inputs[0]))
        except OSError as error:
            self.problem = OSError(error.errno, error.strerror, self.path)
        except MemoryError as error:
            self.problem = error
        return 1

    def write_file(self, surface):
        """Write the file of a surface."""
        model = model_of(vtk_to_numpy(surface.GetPoints().GetData()), triangles_of(surface))
        with zipfile.ZipFile(self.path, "w", zipfile.ZIP_DEFLATED) as file:
            for name, text in (("[Content_Types].xml", TYPES), ("_rels/.rels", RELATIONS), (MODEL, model)):
                file.writestr(zipfile.ZipInfo(name, DATE), text, zipfile.ZIP_DEFLATED)
