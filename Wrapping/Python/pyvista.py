"""Convert surfaces to meshes and textures of PyVista, and add the accessor `conformal` to its meshes.

    import pyvista
    import conformalsom.pyvista

    pyvista.read("scan.ply").conformal.learn().conformal.smooth(64_000).plot()

The accessor needs PyVista 0.48 or later. Every function of conformalsom accepts PyVista's meshes without this
module.
"""
import typing

try:
    import pyvista
except ModuleNotFoundError as error:
    raise ModuleNotFoundError("conformalsom.pyvista needs PyVista: python3-pyvista in Debian 13 and later, or "
                              "pip install pyvista", name="pyvista") from error

import conformalsom


def to_pyvista(surface: conformalsom.Surface) -> pyvista.PolyData:
    """Return a copy of a surface, with all arrays."""
    return surface.to_pyvista()


def texture_of(surface: conformalsom.Surface) -> pyvista.Texture:
    """Return the picture of a painted surface, for plot(texture=...). Raises ValueError without a picture."""
    if surface.texture is None:
        raise ValueError("the surface has no picture; call paint() first")
    texture = pyvista.Texture(surface.texture.copy())
    texture.repeat = False
    return texture


class Conformal:
    """The functions of conformalsom as methods of a mesh of PyVista, which return meshes of PyVista."""

    def __init__(self, mesh: typing.Any) -> None:
        self._mesh = mesh

    def learn(self, **properties: typing.Any) -> pyvista.PolyData:
        """Learn a closed surface from the points, see conformalsom.learn()."""
        return to_pyvista(conformalsom.learn(self._mesh, **properties))

    def conformal_map(self, **properties: typing.Any) -> pyvista.PolyData:
        """Map a closed surface to the sphere, see conformalsom.conformal_map()."""
        return to_pyvista(conformalsom.conformal_map(self._mesh, **properties))

    def smooth(self, number_of_points: typing.Optional[int] = None, **properties: typing.Any) -> pyvista.PolyData:
        """Make a mapped surface smooth and dense, see conformalsom.Surface.smooth()."""
        return to_pyvista(conformalsom.Surface(self._mesh).smooth(number_of_points, **properties))


if hasattr(pyvista, "register_dataset_accessor"):
    pyvista.register_dataset_accessor("conformal", pyvista.DataSet)(Conformal)
