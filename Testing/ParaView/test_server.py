"""A server of two processes, and a client that opens a scan on it and learns its mesh."""
import os
import socket
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from paraview import servermanager
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import scenes


def free_port():
    with socket.socket() as chosen:
        chosen.bind(("localhost", 0))
        return chosen.getsockname()[1]


def learned_points(scan):
    mesh = simple.ConformalSOM(Input=simple.OpenDataFile(scan), NumberOfNeurons=2562)
    mesh.UpdatePipeline()
    return vtk_to_numpy(servermanager.Fetch(mesh).GetPoints().GetData()).copy()


class TestServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="server ")
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.scan = scenes.write_scan(cls.temporary.name, 8000)
        cls.here = learned_points(cls.scan)
        port = free_port()
        cls.server = subprocess.Popen(
            [os.environ["MPIEXEC"], "-np", "2", "pvserver", f"--server-port={port}"],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        cls.addClassCleanup(cls.stop)
        said = []
        for line in cls.server.stdout:  # a try to connect would use up the only connection
            said.append(line)
            if "Accepting connection" in line:
                break
        else:
            raise RuntimeError("pvserver does not start: " + "".join(said))
        simple.Disconnect()
        simple.Connect("localhost", port)

    @classmethod
    def stop(cls):
        cls.server.terminate()
        cls.server.communicate()

    @classmethod
    def tearDownClass(cls):
        simple.Disconnect()

    def test_server_has_two_processes_and_the_plugin(self):
        self.assertEqual(servermanager.ActiveConnection.GetNumberOfDataPartitions(), 2)
        self.assertEqual(simple.OpenDataFile(self.scan).GetXMLName(), "ConformalPLYReader")

    def test_mesh_is_the_one_that_one_process_learns(self):
        np.testing.assert_array_equal(learned_points(self.scan), self.here)

    def test_mesh_is_written_by_the_server(self):
        mesh = simple.ConformalSOM(Input=simple.OpenDataFile(self.scan), NumberOfNeurons=642)
        path = os.path.join(self.temporary.name, "mesh.ply")
        simple.SaveData(path, mesh)
        back = simple.OpenDataFile(path)
        back.UpdatePipeline()
        self.assertEqual(back.GetDataInformation().GetNumberOfPoints(), 642)


if __name__ == "__main__":
    if not os.access(os.environ.get("MPIEXEC", ""), os.X_OK):
        print("mpirun is not installed")
        sys.exit(125)
    unittest.main()
