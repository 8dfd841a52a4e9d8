"""Numbers of points of geodesic spheres."""
import math


def frequency_of(number):
    """The frequency of the geodesic sphere whose number of points, 10 f^2 + 2, is nearest."""
    return min(max(round(math.sqrt((number - 2) / 10)), 1), 1000)
