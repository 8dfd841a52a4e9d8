#!/usr/bin/python3
"""proxies.py OVERLAYS FILE [CLASS...]: write ParaView's proxies of all classes into one file of XML. Overlays
of the named classes are left out, as these are not built.

A proxy follows from the class (describe.py). What no header holds, how the panel shows a property, stands in
OVERLAYS/Name.xml; a class without such needs has none:

    <Overlay label="FreeSurfer Reader"      if it is not the words of the class name
        outputs="Mesh History"              names of the output ports
        mapped="Input Reference"            inputs that need the point array SpherePosition
        advanced="Tolerance Start"          properties and inputs that the panel shows on request
        times="yes"                         if the output has time steps that ParaView plays
        extensions="glb"                    of a writer, if not those of the reader of the same name; "" for none
        file_type="Textured surfaces">      likewise
      <Property name="A B C"                one or more properties or inputs
        shown_if="TrainingMode=Online"      or "TrainingMode!=Online": by the label of the value, or On, Off
        min="0" max="1"                     where the class does not clamp it
        default="0"                         where the class replaces it by what it stands for
        arrays="Input point 1"              of an ...ArrayName: input, attribute, components (0: any number); needed
                                            if there are several inputs; "" for a line in which a name is typed
        labels="GuYau=Gu and Yau"           of values, where it is not the words of SetMethodToGuYau(); by ;
        strings=";Left;Right" />            what a text is chosen from, by ;
      <Move name="A B" after="Input" />     where the panel has another order than the header
      <PropertyGroup> ..., <Hints> ...      and other elements of ParaView are taken over as they are
    </Overlay>

Texts are those of the header: of a property its first paragraph, of a class what stands before its ports.
Constants, properties, classes and ports in them get the names that the panel shows. ParaView's names, such as
SetInputConnection for the first input, are rules of this file.
"""
import glob
import os
import re
import sys
import textwrap
import xml.etree.ElementTree as ElementTree

from describe import Undescribed, classes, paragraphs_of, words_of

CATEGORY = "Conformal SOM"
GROUPS = {  # submenus of filters
    "Surface": ("ConformalSOM", "CurvedSeamlessSurface", "AdaptiveSphere", "GenusZeroCheck", "GenusZeroHull",
                "GenusZeroRepair", "SurfaceMismatch"),
    "Sphere Map": ("GlobalConformalMap", "ConformalDistortion", "SphericalAlignment"),
    "Texture": ("SphericalTextureMap", "SphericalTextureImage", "SphericalTextureBlend", "SurfaceNormalMap",
                "TorusTextureMap"),
    "Correspondence": ("SphericalRegistration", "SphericalMorph", "SphericalResample", "SphericalTemplate",
                       "SphericalTimeSeries", "ConsistentRemesh", "DeformationTransfer"),
    "Shape": ("BodyMap", "BodyMapImage", "MapLabels", "MapOutlines", "SurfaceGeodesics", "SurfaceHarmonics",
              "SphericalSOM", "SurfaceHarmonicsSource", "SurfaceLayers", "SurfaceShape", "VolumeSurfacePoints"),
}
DATA_TYPES = {"vtkPolyData": "polygonal data", "vtkImageData": "image data", "vtkPointSet": "a point set",
              "vtkTable": "a table"}
OVERLAY_ATTRIBUTES = {"label", "outputs", "mapped", "advanced", "times", "extensions", "file_type"}
PROPERTY_ATTRIBUTES = {"name", "shown_if", "min", "max", "default", "arrays", "labels", "strings"}
ELEMENT_TYPES = {"int": "0", "float": "1", "str": "2"}  # ParaView's numbers
OWN_ELEMENTS = ("Property", "Move")


class WrongOverlay(Exception):
    """An overlay that does not fit its class."""


## Overlays -----------------------------------------------------------------------------


class Overlay:
    """What a file adds to the proxy of a class; of a class without a file nothing."""

    def __init__(self, class_, folder):
        self.class_ = class_
        self.path = os.path.join(folder, class_.unit + ".xml")
        self.root = ElementTree.Element("Overlay")
        if os.path.exists(self.path):
            self.root = ElementTree.parse(self.path).getroot()
        self.check_names("attribute", self.root.keys(), OVERLAY_ATTRIBUTES)
        self.inputs = [port.name for port in class_.inputs]
        self.properties = {name: {} for name in [*self.inputs, *(property_.name for property_ in class_.properties)]}
        for element in self.root.findall("Property"):
            self.check_names("attribute", element.keys(), PROPERTY_ATTRIBUTES)
            for name in self.names(element.get("name"), self.properties):
                self.properties[name].update(element.items())
        for name in self.properties:
            self.check_attributes(name)
        self.mapped = self.names(self.root.get("mapped"), self.inputs)
        self.advanced = self.names(self.root.get("advanced"), self.properties)
        self.has_times = self.root.get("times", "no") == "yes"
        self.outputs = self.root.get("outputs", "").split()
        if self.outputs and len(self.outputs) != len(class_.outputs):
            raise self.error(f"it names {len(self.outputs)} outputs, and {class_.name} has {len(class_.outputs)}")
        self.elements = [element for element in self.root if element.tag not in OWN_ELEMENTS]
        for element in self.elements:
            for member in element.iter("Property"):
                self.names(member.get("name"), self.properties)

    def error(self, what):
        """Make an exception that names the file."""
        return WrongOverlay(f"{self.path}: {what}")

    def check_names(self, kind, names, known):
        """Raise unless all names are known."""
        for name in names:
            if name not in known:
                there_are = ", ".join(sorted(known)) or "none"
                raise self.error(f"{self.class_.name} has no {kind} {name}; there are {there_are}")

    def check_attributes(self, name):
        """Raise if the file has something of a property that its kind does not have."""
        known = {"name", "shown_if"}
        for property_ in self.class_.properties:
            if property_.name == name and not property_.repeated:
                known |= attributes_of(property_)
        for attribute in self.properties[name]:
            if attribute not in known:
                raise self.error(f"{name} has no {attribute}; there are {', '.join(sorted(known - {'name'}))}")

    def names(self, text, known):
        """Return the names in a text, all of which must be known."""
        names = (text or "").split()
        self.check_names("input or property", names, known)
        return names

    def get(self, name, attribute, default=None):
        """Return what the file has of an input or property."""
        return self.properties[name].get(attribute, default)

    def arrays(self, name):
        """Return input, attribute and components of the arrays that a property is chosen from; None if it is typed."""
        given = self.get(name, "arrays")
        if given is None and len(self.inputs) > 1:
            raise self.error(f"{self.class_.name} has several inputs; arrays of {name} must name one of them")
        if given == "":
            return None
        arrays = (given or "Input point 0").split()
        self.check_names("input", arrays[:1], self.inputs)
        return arrays

    @property
    def label(self):
        """The name of the proxy in menus."""
        return self.root.get("label", words_of(self.class_.unit))

    def order(self):
        """Return the names of inputs and properties in the panel's order.

        That is the header's, but for inputs that are needed, which come first, and for what the file moves.
        """
        needed = [port.name for port in self.class_.inputs if not port.optional]
        names = needed + [name for name in self.class_.order if name not in needed]
        for element in self.root.findall("Move"):
            [place] = self.names(element.get("after"), names)
            for name in self.names(element.get("name"), names):
                names.remove(name)
                names.insert(names.index(place) + 1, name)
                place = name
        return names

    def labels(self, property_):
        """Return the labels of an enumeration's values, by their numbers."""
        given = dict(item.split("=") for item in self.get(property_.name, "labels", "").split(";") if item)
        self.check_names(f"value of {property_.name}", given, [value.word for value in property_.values])
        return {value.value: given.get(value.word, value.label) for value in property_.values}

    def condition(self, name):
        """Return the property, the value and whether it is inverted, of which it depends that a property is shown."""
        text = self.get(name, "shown_if")
        if not text:
            return None
        found = re.fullmatch(r"(\w+)(!?)=(.*)", text)
        if not found:
            raise self.error(f"shown_if of {name} is neither Property=Value nor Property!=Value: {text}")
        other, inverted, label = found.groups()
        self.check_names("property", [other], [property_.name for property_ in self.class_.properties])
        [property_] = [property_ for property_ in self.class_.properties if property_.name == other]
        labels = self.labels(property_) or {0: "Off", 1: "On"}
        self.check_names(f"value of {other}", [label], labels.values())
        [value] = [value for value, known in labels.items() if known == label]
        return other, value, bool(inverted)


def attributes_of(property_):
    """Return what an overlay may have of a property, besides when it is shown."""
    if property_.values:
        return {"labels", "default"}
    if property_.types == ["str"]:
        return {"arrays"} if property_.name.endswith("ArrayName") else {"strings"}
    return set() if property_.types == ["bool"] else {"min", "max", "default"}


## Texts --------------------------------------------------------------------------------


class Words:
    """The names that panels show for what headers name: constants, properties, classes and ports."""

    def __init__(self, overlays):
        self.overlays = overlays
        self.labels = {class_name: overlay.label for class_name, overlay in overlays.items()}
        self.properties = {name: words_of(name) for overlay in overlays.values() for name in overlay.properties}

    def constants(self, overlay):
        """Return the labels of all constants of a class, and of others where they are no abbreviations, such as OFF."""
        found = {}
        for other in (*self.overlays.values(), overlay):
            for property_ in other.class_.properties:
                labels = other.labels(property_)
                for value in property_.values:
                    found.update({constant: labels[value.value] for constant in value.constants
                                  if other is overlay or len(constant) > 3})
        return found

    def translate(self, text, overlay):
        """Return a text of a header as a panel shows it; names in quotes, as of arrays, stay."""
        constants = self.constants(overlay)
        known = {**self.properties, **constants, **DATA_TYPES, **self.labels}

        def port(match):
            kind, index = (match[1] or "input ").lower(), int(match[2])
            names = overlay.outputs if kind == "output " else ["the input", *overlay.inputs[1:]]
            if index >= len(names):
                return match[0]
            return names[0] if kind == "input " and index == 0 else kind + words_of(names[index])

        pieces = re.split(r'("[^"]*")', text)
        for i in range(0, len(pieces), 2):
            piece = re.sub(r"\b(input |output |Input |Output )?port (\d)\b", port, pieces[i])
            pieces[i] = re.sub(r"\b\w+\b", lambda word: known.get(word[0], word[0]), piece)
        return "".join(pieces)


def sentence(text):
    """Return a text that begins with a capital and ends with a stop."""
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", ":", ")", "!")) else text + "."


def port_text(text):
    """Return the text of a port without the type of data that it begins with."""
    return re.sub(r"^(?:vtk\w+(?:,| whose| with| of|$)\s*)", "", text)


def documentation(text):
    """Make the element of a text."""
    element = ElementTree.Element("Documentation")
    element.text = text
    return element


## Elements -----------------------------------------------------------------------------


def number(value):
    """Write a number as short as possible."""
    return repr(value)[:-2] if repr(value).endswith(".0") else repr(int(value) if isinstance(value, bool) else value)


def add(parent, tag, **attributes):
    """Append an element with attributes; those that are None are left out."""
    return ElementTree.SubElement(parent, tag, {key.rstrip("_"): str(value) for key, value in attributes.items()
                                                if value is not None})


def decorated(element, overlay, name, hints=()):
    """Add the hints of an input or property: those given, and when it is shown."""
    condition = overlay.condition(name)
    if not hints and not condition:
        return element
    parent = add(element, "Hints")
    for hint in hints:
        add(parent, hint)
    if condition:
        add(parent, "PropertyWidgetDecorator", type="GenericDecorator", mode="visibility", property=condition[0],
            value=condition[1], inverse="1" if condition[2] else None)
    return element


class Proxy:
    """The proxy of a class, in the making."""

    def __init__(self, overlay, words):
        self.overlay = overlay
        self.class_ = overlay.class_
        self.words = words

    def text(self, text):
        """Return the first paragraph of a header's text as an element."""
        return documentation(sentence(self.words.translate(paragraphs_of(text)[0], self.overlay)))

    def class_documentation(self):
        """Return the element of the class: its brief, and the description in the header."""
        brief = re.sub(r" \([A-Z]+\)$", "", self.class_.brief)
        element = documentation(self.words.translate(self.class_.text, self.overlay))
        if not self.class_.text:
            raise Undescribed(f"{self.class_.name}: the header has no description between @brief and its first port")
        help_ = sentence(self.words.translate(brief, self.overlay))
        element.attrib.update(short_help=help_, long_help=help_)
        return element

    def arrays(self, port):
        """Return the attribute and the components of arrays that properties choose on an input, if any do."""
        for property_ in self.class_.properties:
            if property_.name.endswith("ArrayName"):
                name, attribute, components = self.overlay.arrays(property_.name) or (None, None, None)
                if name == port:
                    return attribute, None if components == "0" else components
        return None

    def data_types(self, element, port):
        """Add the types of data that an input takes, and the arrays that it has."""
        types = add(element, "DataTypeDomain", name="input_type", composite_data_supported=self.takes_blocks(port))
        for type_ in port.types:
            add(types, "DataType", value=type_)
        if port.name in self.overlay.mapped:
            add(element, "InputArrayDomain", name="mapped", attribute_type="point", number_of_components="3")
        arrays = self.arrays(port.name)
        if arrays:
            add(element, "InputArrayDomain", name="values", attribute_type=arrays[0],
                number_of_components=arrays[1], optional="1")

    def takes_blocks(self, port):
        """Return 1 for an input of blocks, and 0 if VTK cannot run the class for each block, since it makes blocks."""
        if "vtkCompositeDataSet" in port.types:
            return "1"
        return "0" if any("vtkMultiBlockDataSet" in output.types for output in self.class_.outputs) else None

    def input(self, port):
        """Make the element of an input."""
        chosen = port.index > 0 and (port.optional or self.class_.is_writer)
        element = ElementTree.Element("InputProperty", name=port.name)
        element.set("command", "AddInputConnection" if port.repeatable else "SetInputConnection")
        if port.repeatable:
            # RemoveAllInputs() of VTK empties port 0 only.
            clean = "RemoveAll" + port.name + "s" if port.index > 0 else "RemoveAllInputs"
            element.attrib.update(clean_command=clean, multiple_input="1")
        if port.index:
            element.set("port_index", str(port.index))
        if chosen:
            if port.optional:
                element.set("null_on_empty", "1")
            element.attrib.update(panel_widget="input_selector",
                                  panel_visibility="advanced" if port.name in self.overlay.advanced else "default")
        if not self.class_.is_writer or port.index:
            groups = add(element, "ProxyGroupDomain", name="groups")
            for group in ("sources", "filters"):
                add(groups, "Group", name=group)
        self.data_types(element, port)
        if not port.text:
            raise Undescribed(f"{self.class_.name}: the header has no paragraph \"Input port {port.index}: ...\"")
        element.append(self.text(port_text(port.text)))
        return decorated(element, self.overlay, port.name, ["Optional"] * (port.optional and port.index > 0))

    def value(self, property_):
        """Make the element of a property with one value."""
        name, kind = property_.name, kind_of(property_.types)
        default = property_.default if isinstance(property_.default, (tuple, list)) else (property_.default,)
        text = property_.default if kind == "String" else " ".join(map(number, default))
        element = ElementTree.Element(kind + "VectorProperty", name=name, command="Set" + name,
                                      number_of_elements=str(len(default)))
        if name.endswith("FileName") and self.class_.is_reader:
            element.set("animateable", "0")
        else:
            element.set("default_values", self.overlay.get(name, "default", text))
        if name in self.overlay.advanced:
            element.set("panel_visibility", "advanced")
        self.domain(element, property_, kind)
        element.append(self.text(property_.text))
        keeps = self.class_.is_writer and name.endswith("ArrayName")  # ParaView must not replace it by another array
        return decorated(element, self.overlay, name, ["NoDefault"] * keeps)

    def domain(self, element, property_, kind):
        """Add what values a property may have."""
        labels = self.overlay.labels(property_)
        if labels:
            domain = add(element, "EnumerationDomain", name="enum")
            for value in property_.values:
                add(domain, "Entry", text=labels[value.value], value=value.value)
        elif property_.types == ["bool"]:
            add(element, "BooleanDomain", name="bool")
        elif property_.name.endswith("ArrayName"):
            self.array_list(element, property_)
        elif property_.name.endswith("FileName"):
            add(element, "FileListDomain", name="files")
        elif kind == "String":
            self.string_list(element, property_)
        else:
            add(element, kind + "RangeDomain", name="range", min=self.limit(property_, "min", property_.minimum),
                max=self.limit(property_, "max", property_.maximum))

    def limit(self, property_, which, limit):
        """Return a bound of a property: that of the class, or else that of the overlay."""
        given = self.overlay.get(property_.name, which)
        if limit is not None and given is not None:
            raise self.overlay.error(f"{which} of {property_.name} is that of the class, {number(limit)}; "
                                     "leave it out here")
        return number(limit) if limit is not None else given

    def is_gathered(self):
        """Return whether the class writes surfaces, whose pieces of all processes are gathered before."""
        return self.class_.is_writer and any(
            port.index == 0 and port.types == ["vtkPolyData"] for port in self.class_.inputs)

    def array_list(self, element, property_):
        """Add the list of arrays that a property is chosen from; empty stands for none where that is the default."""
        arrays = self.overlay.arrays(property_.name)
        if not arrays:
            return
        domain = add(element, "ArrayListDomain", name="array_list", attribute_type="Scalars",
                     input_domain_name="values", none_string=None if property_.default else "")
        required = add(domain, "RequiredProperties")
        add(required, "Property", name="ArrayInput" if self.is_gathered() else arrays[0], function="Input")

    def string_list(self, element, property_):
        """Add the texts that a property is chosen from. Without any, the panel has a line in which a text is typed."""
        strings = self.overlay.get(property_.name, "strings")
        if strings is not None:
            domain = add(element, "StringListDomain", name="strings")
            for string in strings.split(";"):
                add(domain, "String", value=string)

    def repeated(self, property_):
        """Make the element of a property that is a list."""
        kind = kind_of(property_.types)
        element = ElementTree.Element(
            kind + "VectorProperty", name=property_.name, command=property_.add, number_of_elements="0",
            panel_visibility="advanced", clean_command=property_.remove_all, repeat_command="1",
            number_of_elements_per_command=str(len(property_.types)))
        if len(set(property_.types)) > 1:
            element.set("element_types", " ".join(ELEMENT_TYPES[type_] for type_ in property_.types))
        element.set("animateable", "0")
        element.append(self.text(property_.text))
        return decorated(element, self.overlay, property_.name)

    def members(self):
        """Make the elements of all inputs and properties, in the panel's order; a file's name is not among them."""
        inputs = {port.name: port for port in self.class_.inputs}
        properties = {property_.name: property_ for property_ in self.class_.properties}
        for name in self.overlay.order():
            if name in inputs and not (self.class_.is_writer and name == "Input"):
                yield self.input(inputs[name])
            elif name in properties and name != "FileName":
                yield self.repeated(properties[name]) if properties[name].repeated else self.value(properties[name])

    def hints(self, parent, *hints):
        """Add hints, and those of the overlay."""
        given = [hint for element in self.overlay.elements if element.tag == "Hints" for hint in element]
        if hints or given:
            element = add(parent, "Hints")
            element.extend([*hints, *given])

    def others(self, parent):
        """Add elements of the overlay that are taken over as they are."""
        parent.extend(element for element in self.overlay.elements if element.tag != "Hints")

    def source(self):
        """Make the proxy of a source, filter or reader, in its group."""
        reads = self.class_.is_reader
        group = ElementTree.Element("ProxyGroup", name="filters" if self.class_.inputs else "sources")
        proxy = add(group, "SourceProxy", name=self.class_.unit, class_=self.class_.name, label=self.overlay.label)
        proxy.append(self.class_documentation())
        hints = [ElementTree.Element("ShowInMenu", category=self.category())]
        members = list(self.members())
        if reads:
            proxy.append(file_name(animateable="0"))
            hints = [ElementTree.Element("ReaderFactory", extensions=" ".join(self.class_.extensions),
                                         file_description=f"{self.class_.file_type} ({CATEGORY})")]
            if any(member.find("FileListDomain") is not None for member in members):
                hints.insert(0, ElementTree.Element("DefaultFileNameProperty", name="FileName"))
        proxy.extend(members)
        self.others(proxy)
        if self.overlay.has_times:
            times = add(proxy, "DoubleVectorProperty", name="TimestepValues", repeatable="1", information_only="1")
            add(times, "TimeStepsInformationHelper")
            times.append(documentation("Available time steps."))
        if len(self.class_.outputs) > 1 and not self.overlay.outputs:
            raise self.overlay.error(f"{self.class_.name} has several outputs; outputs must name them")
        for index, name in enumerate(self.overlay.outputs):
            add(proxy, "OutputPort", index=index, name=name)
        self.hints(proxy, *hints)
        return [group]

    def category(self):
        """Return the submenu of the proxy."""
        if not self.class_.inputs:
            return CATEGORY
        for group, units in GROUPS.items():
            if self.class_.unit in units:
                return f"{CATEGORY}: {group}"
        raise Undescribed(f"{self.class_.name} is in none of the GROUPS of {os.path.basename(__file__)}")

    def writer_factory(self, readers):
        """Return the hint by which a writer's files are known: of the reader of the same name, or the overlay."""
        reader = readers.get(self.class_.name.replace("Writer", "Reader"))
        extensions = self.overlay.root.get("extensions", " ".join(reader.extensions) if reader else None)
        file_type = self.overlay.root.get("file_type", reader.file_type if reader else None)
        if extensions is None:
            raise self.overlay.error(f"{self.class_.name} has no reader of the same name: "
                                     "extensions and file_type are needed")
        if not extensions:
            return []
        return [ElementTree.Element("WriterFactory", extensions=extensions,
                                    file_description=f"{file_type} ({CATEGORY})")]

    def writer(self, readers):
        """Make the proxy of a writer, in its group; of surfaces the pieces of all processes are gathered before."""
        group = ElementTree.Element("ProxyGroup", name="writers")
        [port] = [port for port in self.class_.inputs if port.index == 0]
        gathered = self.is_gathered()
        inner = []
        if gathered:
            core, exposed = self.core(port)
            inner = [core]
            proxy = add(group, "PSWriterProxy", name=self.class_.unit, class_="vtkParallelSerialWriter",
                        label=self.overlay.label, file_name_method="SetFileName", base_proxygroup="internal_writers",
                        base_proxyname="ParallelSerialWriter")
        else:
            proxy = add(group, "WriterProxy", name=self.class_.unit, class_=self.class_.name, label=self.overlay.label)
        proxy.append(self.class_documentation())
        if gathered:
            self.sub_proxy(proxy, exposed)
        element = self.input(port)
        element.set("panel_visibility", "never")
        for domain in element.findall("InputArrayDomain") if gathered else []:
            element.remove(domain)
        proxy.append(element)
        proxy.append(file_name(writes=not gathered))
        proxy.extend([] if gathered else self.members())
        if gathered:
            helper = add(proxy, "SubProxy")
            add(helper, "Proxy", name="PostGatherHelper", proxygroup="filters", proxyname="AppendPolyData")
        self.hints(proxy, *self.writer_factory(readers))
        return [*inner, group]

    def core(self, port):
        """Make the proxy with the properties of a writer, in its group, and return their names too."""
        group = ElementTree.Element("ProxyGroup", name="internal_writers")
        proxy = add(group, "Proxy", name=self.class_.unit + "Core", class_=self.class_.name)
        members = list(self.members())
        if self.arrays(port.name):
            menu = add(proxy, "InputProperty", name="ArrayInput", panel_visibility="never")
            self.data_types(menu, port)
            menu.append(documentation("What is written, for the menu of its arrays."))
        proxy.extend(members)
        self.others(proxy)
        return group, [member.get("name") for member in members]

    def sub_proxy(self, proxy, exposed):
        """Add the proxy that has a writer's properties, and show these."""
        sub_proxy = add(proxy, "SubProxy")
        add(sub_proxy, "Proxy", name="Writer", proxygroup="internal_writers", proxyname=self.class_.unit + "Core")
        if exposed:
            names = add(sub_proxy, "ExposedProperties")
            for name in exposed:
                add(names, "Property", name=name)
        if self.arrays("Input"):
            links = add(sub_proxy, "LinkProperties")
            add(links, "Property", name="ArrayInput", with_property="Input")


def kind_of(types):
    """Return ParaView's word for the types of a property's values."""
    if "str" in types:
        return "String"
    return "Double" if "float" in types else "Int"


def file_name(animateable=None, writes=False):
    """Make the element of the name of the file to read or write."""
    element = ElementTree.Element("StringVectorProperty", name="FileName", command="SetFileName",
                                  number_of_elements="1")
    if animateable:
        element.set("animateable", animateable)
    element.set("panel_visibility", "never")
    if animateable or writes:
        add(element, "FileListDomain", name="files")
    element.append(documentation("The file to read." if animateable else "Name of the file."))
    return element


## File ---------------------------------------------------------------------------------


def overlays_of(described, folder, left_out=()):
    """Read the overlays of all classes but those left out."""
    for path in glob.glob(os.path.join(folder, "*.xml")):
        name = os.path.splitext(os.path.basename(path))[0]
        if "vtk" + name not in {*described, *left_out}:
            raise WrongOverlay(f"{path}: there is no class vtk{name} that makes objects for a pipeline")
    return {name: Overlay(class_, folder) for name, class_ in described.items()}


def proxies(described, folder, left_out=()):
    """Make the element of all proxies."""
    root = ElementTree.Element("ServerManagerConfiguration")
    overlays = overlays_of(described, folder, left_out)
    words = Words(overlays)
    for overlay in overlays.values():
        proxy = Proxy(overlay, words)
        root.extend(proxy.writer(described) if overlay.class_.is_writer else proxy.source())
    for text in root.iter("Documentation"):
        text.text = "\n".join(textwrap.fill(line, 100, break_on_hyphens=False) for line in text.text.split("\n"))
    ElementTree.indent(root)
    return root


def main(folder, path, *left_out):
    """Write the file."""
    try:
        text = ElementTree.tostring(proxies(classes(), folder, left_out), encoding="unicode") + "\n"
    except (Undescribed, WrongOverlay) as error:
        sys.exit(str(error))
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
