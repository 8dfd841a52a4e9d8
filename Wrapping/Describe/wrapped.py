"""What VTK's Python wrapper keeps of a header: signatures, texts, and which classes are of this package.

The wrapper begins the text of a method with its signatures, in Python and in C++; the header's text follows.
Methods of one group, as those of a property, share one text in a header, and the wrapper gives it to the
first of them only.
"""
import inspect
import re

MADE_BY_MACRO = ("SafeDownCast", "NewInstance")


def is_ours(class_):
    """Whether a class is of this package."""
    return class_.__module__.startswith("conformalsom.")


def signatures_of(name, method):
    """Return the lines of the wrapper that declare a method in Python."""
    head = (method.__doc__ or "").partition("\n\n")[0]
    return [line for line in re.sub(r"\n +", " ", head).split("\n") if line.startswith(name + "(")]


def text_of(method):
    """Return the header's text of a method."""
    return (method.__doc__ or "").partition("\n\n")[2].strip()


def texts_of(class_):
    """Return the texts of all methods by name.

    In a class of this package a method without a text has that of the method before it, with which it is in
    a group of the header.
    """
    texts, text = {}, ""
    for name, member in vars(class_).items():
        if inspect.isroutine(member):
            text = text_of(member) or (text if name not in MADE_BY_MACRO and is_ours(class_) else "")
            texts[name] = text
    return texts
