"""A source of VTK that reads a file by a function of Python."""
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkPolyData


class PythonReader(VTKPythonAlgorithmBase):
    """Reads a surface or cloud. Derived classes set the function.

    It cannot run on another thread.
    """

    @staticmethod
    def read_file(path):
        """The surface or cloud of a file, and a warning or an empty text. Raises ValueError and OSError."""
        raise NotImplementedError

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self.path = ""

    def SetFileName(self, path):  # pylint: disable=invalid-name
        """Set the file to read."""
        if path != self.path:
            self.path = path
            self.Modified()

    def GetOutput(self):  # pylint: disable=invalid-name
        """Return the surface or cloud."""
        return self.GetOutputDataObject(0)

    def RequestData(self, _request, _inputs, outputs):  # pylint: disable=invalid-name
        """Read the file. What is wrong with it is an ErrorEvent or a WarningEvent."""
        try:
            data, warning = self.read_file(self.path)
        except (ValueError, OSError) as error:
            self.report("ErrorEvent", str(error))
            return 0
        if warning:
            self.report("WarningEvent", warning)
        vtkPolyData.GetData(outputs).ShallowCopy(data)
        return 1

    def report(self, event, text):
        """Invoke an event, or print the text if there is no observer, as filters of VTK do."""
        if self.HasObserver(event):
            self.InvokeEvent(event, text)
        else:
            vtkOutputWindow.GetInstance().DisplayErrorText(f"{self.path}: {text}\n")
