"""ParaView's proxies are made of the classes: texts for a panel, domains, files, and clear errors of overlays.

No ParaView is needed for that; what needs one is tested in Testing/ParaView.
"""
import os
import re
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import conformalsom
from vtkmodules.vtkCommonDataModel import vtkDataObjectTypes, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkTrivialProducer

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
FOLDER = os.path.join(SOURCE, "Wrapping", "ParaView")
sys.path.insert(0, os.path.join(SOURCE, "Wrapping", "Describe"))
import describe
import proxies

# ParaView's own processes are the default controller. A panel selects one source for each input.
LEFT_OUT = {"Controller", "LevelConnection", "LevelData"}
VALUES = ("IntVectorProperty", "DoubleVectorProperty", "StringVectorProperty")
LONGEST_TEXT = 640  # of a tooltip
CLASSES = describe.classes()
ROOT = proxies.proxies(CLASSES, FOLDER)


def proxy_of(name):
    """The proxy that is shown for a class, and the one that has the class's properties."""
    found = [proxy for group in ROOT for proxy in group]
    shown, = (proxy for proxy in found if proxy.get("name") == name)
    core, = (proxy for proxy in found if proxy.get("class") == "vtk" + name)
    return shown, core


def documented():
    """All elements of which the panel shows a text, with the name of their proxy."""
    for proxy in (proxy for group in ROOT for proxy in group):
        for element in proxy:
            if element.tag in VALUES + ("InputProperty",):
                yield proxy.get("name"), element


class TestProxies(unittest.TestCase):

    def test_every_algorithm_has_a_proxy(self):
        self.assertGreater(len(CLASSES), 25)
        for name, cls in vars(conformalsom).items():
            if isinstance(cls, type) and issubclass(cls, vtkAlgorithm) and name not in CLASSES:
                with self.subTest(name):
                    self.assertRaises((NotImplementedError, TypeError), cls)  # a base of others
        for class_ in CLASSES.values():
            with self.subTest(class_.name):
                proxy_of(class_.unit)

    def test_every_setting_is_a_property(self):
        """Set...(), Add...() and their ports; SetMethodToRobust() is a value of Method."""
        for class_ in CLASSES.values():
            _, core = proxy_of(class_.unit)
            commands = {element.get("command") for element in core} | {"SetFileName"}
            inputs = {element.get("name") for element in core.findall("InputProperty")}
            for base in getattr(conformalsom, class_.name).__mro__:
                methods = [method for method in vars(base) if method.startswith(("Set", "Add"))]
                for method in methods if base.__module__.startswith("conformalsom") else []:
                    name = method[len("Set"):]
                    if name in LEFT_OUT or any(method.startswith(other + "To") for other in methods):
                        continue
                    port = re.fullmatch("(.+)(Connection|Data)", name)
                    with self.subTest(class_.name + "::" + method):
                        self.assertTrue(port and port.group(1) in inputs or method in commands)

    def test_a_proxy_in_full(self):
        """A known answer."""
        shown, _ = proxy_of("GenusZeroRepair")
        self.assertEqual(shown.attrib, {"name": "GenusZeroRepair", "class": "vtkGenusZeroRepair",
                                        "label": "Genus Zero Repair"})
        area = shown.find("DoubleVectorProperty")
        self.assertEqual(area.attrib, {"name": "MaximumHoleArea", "command": "SetMaximumHoleArea",
                                       "number_of_elements": "1", "default_values": "0.25"})
        self.assertEqual(area.find("DoubleRangeDomain").attrib, {"name": "range", "min": "0", "max": "1"})
        self.assertIn("Maximum size of a hole that is filled", area.findtext("Documentation"))
        self.assertEqual([port.get("name") for port in shown.findall("OutputPort")], ["Surface", "Loops"])
        self.assertEqual(shown.find("Hints/ShowInMenu").get("category"), "Conformal SOM: Surface")
        self.assertEqual(shown.find("InputProperty/DataTypeDomain/DataType").get("value"), "vtkPolyData")

    def test_every_value_has_a_domain(self):
        for name, element in documented():
            if element.get("command") and element.tag != "InputProperty" and element.get("name") != "FileName":
                is_typed = element.tag == "StringVectorProperty" or element.get("repeat_command")
                with self.subTest(f"{name}.{element.get('name')}"):
                    self.assertTrue(is_typed or any(child.tag.endswith("Domain") for child in element))

    def test_texts_are_typed_or_chosen_from_a_list(self):
        """A list of an empty text alone would be a menu in which nothing can be chosen."""
        def element_of(class_name, property_name):
            return next(element for element in proxy_of(class_name)[1] if element.get("name") == property_name)

        self.assertIsNone(element_of("SphericalSOM", "LabelColumn").find("StringListDomain"))
        chosen = element_of("GIFTIWriter", "AnatomicalStructure").find("StringListDomain")
        self.assertEqual([string.get("value") for string in chosen][1:], ["CortexLeft", "CortexRight", "Cerebellum"])

    def test_arrays_are_those_of_the_input_that_has_them(self):
        for class_name, name in (("SurfaceLayers", "Volume"), ("MapLabels", "Labels"), ("SphericalResample", "Source")):
            inputs = [list_.find("RequiredProperties/Property").get("name")
                      for list_ in proxy_of(class_name)[1].iter("ArrayListDomain")]
            with self.subTest(class_name):
                self.assertEqual(inputs, [name])
        self.assertEqual(list(proxy_of("SphericalTextureImage")[1].iter("ArrayListDomain")), [])  # of Source or Input

    def test_every_output_of_several_has_a_name(self):
        for class_ in CLASSES.values():
            names = [port.get("name") for port in proxy_of(class_.unit)[0].findall("OutputPort")]
            with self.subTest(class_.name):
                self.assertEqual(len(names or class_.outputs[:1]), len(class_.outputs))

    def test_blocks_are_taken_one_by_one_or_not_at_all(self):
        """VTK runs a filter for each block, but not one that makes blocks itself."""
        taken = {name: proxy_of(name)[0].find("InputProperty/DataTypeDomain").get("composite_data_supported")
                 for name in ("ConformalSOM", "CurvedSeamlessSurface", "ConsistentRemesh")}
        self.assertEqual(taken, {"ConformalSOM": "0", "CurvedSeamlessSurface": None, "ConsistentRemesh": "1"})

    def test_texts_are_short_and_for_a_panel(self):
        """No names of C++ and Python, which a header has: classes, methods, constants, ports."""
        pattern = r"\bvtk[A-Z]\w*|\w+::|\bSet[A-Z]\w+|\bport \d|@\w+|\b[A-Z]+_[A-Z_]+\b"
        for name, element in documented():
            text = " ".join(element.findtext("Documentation").split())
            with self.subTest(f"{name}.{element.get('name')}"):
                self.assertGreater(len(text), 8)
                self.assertTrue(text.endswith("."), text)
                self.assertLessEqual(len(text), LONGEST_TEXT, "in the header, begin a paragraph after what users need")
                self.assertEqual(re.findall(pattern, text), [])
        for class_ in CLASSES.values():
            text = proxy_of(class_.unit)[0].find("Documentation")
            with self.subTest(class_.name):
                self.assertGreater(len(text.text), 20)
                self.assertEqual(re.findall(pattern, text.text + text.get("short_help")), [])

    def test_labels_are_the_words_of_the_class(self):
        """Scripts call proxies and properties by their labels without the blanks."""
        for class_ in CLASSES.values():
            with self.subTest(class_.name):
                self.assertEqual(proxy_of(class_.unit)[0].get("label").replace(" ", ""), class_.unit)
        for name, element in documented():
            with self.subTest(f"{name}.{element.get('name')}"):
                self.assertIsNone(element.get("label"))

    def test_every_other_input_is_set_by_its_name(self):
        """As a connection and as data, in Python as in ParaView."""
        for class_ in CLASSES.values():
            object_ = getattr(conformalsom, class_.name)()
            for port in class_.inputs[1:]:
                # Data of any type derived from an abstract one.
                concrete = {"vtkPointSet": "vtkPolyData", "vtkCompositeDataSet": "vtkMultiBlockDataSet"}
                data = vtkDataObjectTypes.NewDataObject(concrete.get(port.types[0], port.types[0]))
                with self.subTest(f"{class_.name}.{port.name}"):
                    producer = vtkTrivialProducer()
                    verb = "Add" if port.repeatable else "Set"
                    getattr(object_, f"{verb}{port.name}Connection")(producer.GetOutputPort())
                    self.assertIs(object_.GetInputAlgorithm(port.index, 0), producer)
                    getattr(object_, f"{verb}{port.name}Data")(data)
                    last = object_.GetNumberOfInputConnections(port.index) - 1
                    self.assertIs(object_.GetInputDataObject(port.index, last), data)

    def test_files_find_their_readers_and_writers(self):
        for class_ in CLASSES.values():
            shown, _ = proxy_of(class_.unit)
            with self.subTest(class_.name):
                if class_.is_reader:
                    hint = shown.find("Hints/ReaderFactory")
                    self.assertEqual(hint.get("extensions"), " ".join(class_.extensions))
                    self.assertTrue(callable(getattr(conformalsom, class_.name).CanReadFile))
                    if len(list(shown.iter("FileListDomain"))) > 1:
                        name = shown.find("Hints/DefaultFileNameProperty").get("name")
                        self.assertEqual(name, "FileName")  # what File > Open sets
                elif class_.is_writer and class_.name != "vtkSPHARMSurfaceWriter":  # .vtk is ParaView's own
                    hint = shown.find("Hints/WriterFactory")
                    self.assertIn("(Conformal SOM)", hint.get("file_description"))
                    reader = CLASSES.get(class_.name.replace("Writer", "Reader"))
                    known = reader.extensions if reader else ["glb", "html"]
                    self.assertLessEqual(set(hint.get("extensions").split()), set(known))


class TestOverlays(unittest.TestCase):
    """What does not fit the class is named, so that a renamed property is found at once."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="overlays ")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def made(self, overlay, name="GlobalConformalMap"):
        """The proxy of a class with an overlay."""
        with open(os.path.join(self.folder, name + ".xml"), "w", encoding="utf-8") as file:
            file.write(overlay)
        class_ = CLASSES["vtk" + name]
        overlay = proxies.Overlay(class_, self.folder)
        return proxies.Proxy(overlay, proxies.Words({class_.name: overlay})).source()[0][0]

    def expect(self, overlay, *words):
        """An overlay is an error that has these words."""
        with self.assertRaises(proxies.WrongOverlay) as raised:
            self.made(overlay)
        for word in ("GlobalConformalMap.xml", *words):
            self.assertIn(word, str(raised.exception))

    def test_names_that_there_are_not(self):
        self.expect('<Overlay advanced="Toleranze" />', "no input or property Toleranze", "Tolerance")
        self.expect('<Overlay mapped="Sphere" />', "no input or property Sphere", "Input")
        self.expect('<Overlay><Property name="Toleranze" min="0" /></Overlay>', "Toleranze")
        self.expect('<Overlay><Move name="Toleranze" after="Input" /></Overlay>', "Toleranze")
        self.expect('<Overlay><Move name="Tolerance" after="Inputt" /></Overlay>', "Inputt")
        self.expect('<Overlay><PropertyGroup><Property name="Gone" /></PropertyGroup></Overlay>', "Gone")
        self.expect('<Overlay lable="Map" />', "no attribute lable")
        self.expect('<Overlay><Property name="Method" shown="1" /></Overlay>', "no attribute shown")

    def test_values_that_there_are_not(self):
        self.expect('<Overlay><Property name="Tolerance" shown_if="Method=Rubust" /></Overlay>', "Rubust", "Robust")
        self.expect('<Overlay><Property name="Tolerance" shown_if="Way=Robust" /></Overlay>', "Way", "Method")
        self.expect('<Overlay><Property name="Tolerance" shown_if="Method" /></Overlay>', "neither")
        self.expect('<Overlay><Property name="Method" labels="Rubust=Robust" /></Overlay>', "Rubust")
        self.expect('<Overlay outputs="One Two" />', "2 outputs")
        with self.assertRaisesRegex(proxies.WrongOverlay, "vtkSurfaceLayers has several inputs; arrays of ArrayName"):
            self.made('<Overlay outputs="Surface Layers Map" />', "SurfaceLayers")

    def test_what_the_class_has_itself(self):
        self.expect('<Overlay><Property name="Tolerance" max="2" /></Overlay>', "max of Tolerance", "leave it out")

    def test_what_a_kind_of_property_does_not_have(self):
        self.expect('<Overlay><Property name="Method" min="0" /></Overlay>', "Method has no min")
        self.expect('<Overlay><Property name="Tolerance" arrays="Input any 1" /></Overlay>', "Tolerance has no arrays")
        self.expect('<Overlay><Property name="Input" labels="A=B" /></Overlay>', "Input has no labels")

    def test_an_overlay_without_a_class(self):
        with open(os.path.join(self.folder, "Gone.xml"), "w", encoding="utf-8") as file:
            file.write("<Overlay />")
        with self.assertRaisesRegex(proxies.WrongOverlay, "Gone.xml: there is no class vtkGone"):
            proxies.overlays_of(CLASSES, self.folder)
        self.assertNotIn("vtkGone", proxies.overlays_of(CLASSES, self.folder, ["vtkGone"]))

    def test_what_it_adds(self):
        made = self.made("""
            <Overlay label="Global Map" mapped="Input" advanced="Method" outputs="Mapped">
              <Property name="AreaBalance Tolerance" shown_if="Method!=Gu-Yau" />
              <Property name="Method" labels="GuYau=Gu-Yau" />
              <Move name="Tolerance Method" after="AreaBalance" />
              <Hints><View type="None" /></Hints>
            </Overlay>""")
        names = [element.get("name") for element in made if element.get("command")]
        self.assertEqual(names, ["Input", "AreaBalance", "Tolerance", "Method", "MaximumNumberOfIterations"])
        elements = {element.get("name"): element for element in made}
        self.assertEqual(made.get("label"), "Global Map")
        self.assertEqual(elements["Input"].find("InputArrayDomain").get("name"), "mapped")
        self.assertEqual(elements["Method"].get("panel_visibility"), "advanced")
        self.assertEqual([entry.get("text") for entry in elements["Method"].iter("Entry")], ["Robust", "Gu-Yau"])
        self.assertIn("Gu-Yau", elements["Method"].findtext("Documentation"))
        decorator = elements["AreaBalance"].find("Hints/PropertyWidgetDecorator")
        self.assertEqual([decorator.get(key) for key in ("property", "value", "inverse")], ["Method", "1", "1"])
        self.assertIsNone(elements["MaximumNumberOfIterations"].find("Hints"))
        self.assertEqual([hint.tag for hint in made.find("Hints")], ["ShowInMenu", "View"])
        self.assertEqual(made.find("OutputPort").get("name"), "Mapped")

    def test_the_file_is_that_of_all_overlays(self):
        path = os.path.join(self.folder, "proxies.xml")
        proxies.main(FOLDER, path)
        count = sum(len(group) for group in ElementTree.parse(path).getroot())
        self.assertEqual(count, sum(len(group) for group in ROOT))


if __name__ == "__main__":
    unittest.main()
