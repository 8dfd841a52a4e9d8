"""ParaView's XML says of every class what the class itself says: commands, defaults, ranges, ports.

No ParaView is needed for that; what needs one is tested in Testing/ParaView.
"""
import glob
import os
import re
import unittest
import xml.etree.ElementTree as ElementTree

import conformalsom
from vtkmodules.vtkCommonDataModel import vtkDataObjectTypes, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkTrivialProducer

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
FOLDER = os.path.join(SOURCE, "Wrapping", "ParaView")
LEFT_OUT = {"Controller"}  # ParaView's own processes, which is the default
VALUES = ("IntVectorProperty", "DoubleVectorProperty", "StringVectorProperty")


def sentence(text):
    """The text without blanks, case, remarks in brackets and final stop, for comparisons."""
    return re.sub(r"\([^)]*\)|\.$|\s", "", text.strip()).lower()


def numbers(text):
    return [float(word) for word in text.split()]


class Proxy:
    """One file: the proxy that users see, and the one that has the class's properties."""

    def __init__(self, path):
        self.name = os.path.splitext(os.path.basename(path))[0]
        proxies = [proxy for group in ElementTree.parse(path).getroot() for proxy in group]
        self.shown, = (proxy for proxy in proxies if proxy.get("name") == self.name)
        self.class_name = "vtk" + self.name
        self.core, = (proxy for proxy in proxies if proxy.get("class") == self.class_name)
        self.proxies = proxies
        self.type = getattr(conformalsom, self.class_name)
        self.object = self.type()

    def properties(self, *kinds):
        """Properties that set something in the class."""
        return [element for element in self.core if element.tag in kinds and element.get("command")]

    def documented(self):
        """All that must say what it is for."""
        for proxy in self.proxies:
            for element in proxy:
                if element.tag in VALUES + ("InputProperty",):
                    yield element

    def is_writer(self):
        return self.name.endswith("Writer")


def setters(cls):
    """Names of the settings of a class and of its bases in the package, from its methods."""
    for base in cls.__mro__:
        if not base.__module__.startswith("conformalsom"):
            continue
        methods = vars(base)
        for method in methods:
            if not method.startswith(("Set", "Add")):
                continue
            name = method[len("Set"):]
            if any(name.startswith(other[len("Set"):] + "To") for other in methods
                   if other.startswith("Set") and other != method):
                continue  # SetMethodToRobust
            yield name


PROXIES = [Proxy(path) for path in sorted(glob.glob(os.path.join(FOLDER, "*.xml")))]


def of_each_proxy(test):
    """A test that is told a proxy, of all of them."""
    def all_of_them(self):
        for proxy in PROXIES:
            with self.subTest(proxy.name):
                test(self, proxy)
    all_of_them.__doc__ = test.__doc__
    return all_of_them


class TestProxies(unittest.TestCase):

    def test_every_algorithm_has_its_file(self):
        found = {proxy.class_name for proxy in PROXIES}
        self.assertGreater(len(found), 25)
        for name, cls in vars(conformalsom).items():
            if isinstance(cls, type) and issubclass(cls, vtkAlgorithm) and name not in found:
                with self.subTest(name):
                    self.assertRaises((NotImplementedError, TypeError), cls)  # a base of others

    @of_each_proxy
    def test_every_setting_is_a_property(self, proxy):
        known = {element.get("command")[len("Set"):]
                 for element in proxy.properties(*VALUES)}
        inputs = {element.get("name") for element in proxy.properties("InputProperty")}
        if proxy.is_writer():
            known.add("FileName")  # given by ParaView's own writer around ours
        for name in set(setters(proxy.type)) - LEFT_OUT:
            port = re.fullmatch("(.+)(Connection|Data)", name)
            if port:
                self.assertIn(port.group(1), inputs)
            else:
                self.assertIn(name, known)

    @of_each_proxy
    def test_every_command_is_a_method_named_as_the_property(self, proxy):
        for element in proxy.properties(*VALUES):
            self.assertTrue(hasattr(proxy.object, element.get("command")))
            self.assertIn(element.get("command"),
                          ("Set" + element.get("name"), "Add" + element.get("name")[:-1]))
            for other in ("clean_command", "set_number_command"):
                if element.get(other):
                    self.assertTrue(hasattr(proxy.object, element.get(other)))

    @of_each_proxy
    def test_defaults_are_those_of_the_class(self, proxy):
        for element in proxy.properties(*VALUES):
            name, default = element.get("name"), element.get("default_values")
            if element.get("repeat_command"):
                self.assertIsNone(default)
                continue
            value = getattr(proxy.object, "Get" + name)()
            with self.subTest(name):
                if element.tag == "StringVectorProperty":
                    self.assertEqual(default or "", value or "")
                else:
                    values = value if isinstance(value, tuple) else (value,)
                    self.assertEqual(numbers(default), [float(v) for v in values])
                    self.assertEqual(int(element.get("number_of_elements")), len(values))

    @of_each_proxy
    def test_ranges_are_those_of_the_class(self, proxy):
        """A clamp of the class is the range, or the values of the menu; VTK_INT_MAX means none."""
        endless = 2.0**31 - 1
        for element in proxy.properties("IntVectorProperty", "DoubleVectorProperty"):
            name = element.get("name")
            if not hasattr(proxy.object, f"Get{name}MinValue"):
                continue
            with self.subTest(name):
                low = getattr(proxy.object, f"Get{name}MinValue")()
                high = getattr(proxy.object, f"Get{name}MaxValue")()
                menu = element.find("EnumerationDomain")
                if menu is not None:
                    values = sorted(int(entry.get("value")) for entry in menu)
                    self.assertEqual(values, list(range(low, high + 1)))
                    continue
                domain = element.find(element.tag.replace("VectorProperty", "RangeDomain"))
                self.assertEqual(float(domain.get("min")), low)
                if domain.get("max") is not None:
                    self.assertEqual(float(domain.get("max")), high)
                else:
                    self.assertGreaterEqual(high, endless)

    @of_each_proxy
    def test_every_value_has_a_domain(self, proxy):
        for element in proxy.properties(*VALUES):
            with self.subTest(element.get("name")):
                self.assertTrue(element.get("repeat_command") or
                                any(child.tag.endswith("Domain") for child in element))

    @of_each_proxy
    def test_ports_are_those_of_the_class(self, proxy):
        inputs = proxy.properties("InputProperty")
        ports = sorted(int(element.get("port_index", 0)) for element in inputs)
        if proxy.core is not proxy.shown:
            ports.insert(0, 0)  # given by ParaView's own writer around ours
        self.assertEqual(ports, list(range(proxy.object.GetNumberOfInputPorts())))
        for element in inputs:
            port = int(element.get("port_index", 0))
            needed = proxy.object.GetInputPortInformation(port)
            types = [needed.Get(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), i)
                     for i in range(needed.Length(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()))]
            self.assertEqual([value.get("value") for value in element.iter("DataType")], types)
            self.assertEqual(element.find("Hints/Optional") is not None,
                             bool(needed.Get(vtkAlgorithm.INPUT_IS_OPTIONAL())))
        outputs = [element.get("name") for element in proxy.core.findall("OutputPort")]
        if proxy.object.GetNumberOfOutputPorts() > 1:
            self.assertEqual(len(outputs), proxy.object.GetNumberOfOutputPorts())

    @of_each_proxy
    def test_every_other_input_is_set_by_its_name(self, proxy):
        """As a connection and as data, in Python as in ParaView."""
        for element in proxy.properties("InputProperty"):
            port = int(element.get("port_index", 0))
            if port == 0:
                continue
            name = element.get("name")
            needed = proxy.object.GetInputPortInformation(port)
            type_name = needed.Get(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), 0)
            data = vtkPolyData() if type_name == "vtkPointSet" else (
                vtkDataObjectTypes.NewDataObject(type_name))
            with self.subTest(name):
                producer = vtkTrivialProducer()
                getattr(proxy.object, f"Set{name}Connection")(producer.GetOutputPort())
                self.assertIs(proxy.object.GetInputAlgorithm(port, 0), producer)
                getattr(proxy.object, f"Set{name}Data")(data)
                self.assertIs(proxy.object.GetInputDataObject(port, 0), data)

    @of_each_proxy
    def test_everything_is_documented(self, proxy):
        for element in proxy.documented():
            with self.subTest(element.get("name")):
                self.assertGreater(len(element.findtext("Documentation").strip()), 8)
        self.assertGreater(len(proxy.shown.findtext("Documentation").strip()), 20)

    @of_each_proxy
    def test_help_is_that_of_the_header(self, proxy):
        pattern = os.path.join(SOURCE, "*", "*", proxy.class_name + ".h")
        with open(glob.glob(pattern)[0], encoding="ascii") as file:
            brief = re.search(r"@brief +((?:.|\n)*?)\n \*\n", file.read()).group(1)
        self.assertEqual(sentence(proxy.shown.find("Documentation").get("short_help")),
                         sentence(brief.replace("\n *", " ")))

    @of_each_proxy
    def test_labels_are_the_words_of_the_class(self, proxy):
        """Scripts call proxies and properties by their labels without the blanks."""
        self.assertEqual(proxy.shown.get("label").replace(" ", ""), proxy.name)
        for element in proxy.documented():
            self.assertIsNone(element.get("label"))

    @of_each_proxy
    def test_what_shows_only_sometimes_names_properties_that_are_there(self, proxy):
        names = {element.get("name"): element for element in proxy.core if element.get("name")}
        for decorator in proxy.core.iter("PropertyWidgetDecorator"):
            menu = names[decorator.get("property")].find("EnumerationDomain")
            values = ("0", "1") if menu is None else [entry.get("value") for entry in menu]
            self.assertIn(decorator.get("value"), values)
        for member in proxy.core.iterfind("PropertyGroup/Property"):
            self.assertIn(member.get("name"), names)

    @of_each_proxy
    def test_sources_and_filters_are_in_the_menu(self, proxy):
        if "Reader" in proxy.name or proxy.is_writer():
            return
        self.assertEqual(proxy.shown.find("Hints/ShowInMenu").get("category"), "Conformal SOM")

    @of_each_proxy
    def test_files_are_told_by_the_readers_extensions(self, proxy):
        if "Reader" not in proxy.name:
            return
        hint = proxy.shown.find("Hints/ReaderFactory")
        self.assertEqual(hint.get("extensions"),
                         proxy.object.GetFileExtensions().replace(".", ""))
        self.assertEqual(hint.get("file_description"),
                         proxy.object.GetDescriptiveName() + " (Conformal SOM)")
        self.assertTrue(callable(proxy.type.CanReadFile))
        if len(list(proxy.shown.iter("FileListDomain"))) > 1:
            name = proxy.shown.find("Hints/DefaultFileNameProperty").get("name")
            self.assertEqual(name, "FileName")  # what File > Open sets

    @of_each_proxy
    def test_writers_are_chosen_by_extensions_that_readers_know(self, proxy):
        if not proxy.is_writer():
            return
        hint = proxy.shown.find("Hints/WriterFactory")
        if proxy.name == "SPHARMSurfaceWriter":
            self.assertIsNone(hint)  # .vtk is ParaView's own
            return
        self.assertIn("(Conformal SOM)", hint.get("file_description"))
        reader = "vtk" + proxy.name.replace("Writer", "Reader")
        known = ".glb .html"
        if hasattr(conformalsom, reader):
            known = getattr(conformalsom, reader)().GetFileExtensions()
        for extension in hint.get("extensions").split():
            self.assertIn("." + extension, known)


if __name__ == "__main__":
    unittest.main()
