"""Report the progress of a filter: by a function, by a bar of tqdm, or as one line of a terminal."""
import contextlib
import sys
import typing

Report = typing.Callable[[float], object]
Progress = typing.Union[bool, Report]


@contextlib.contextmanager
def reporter(progress: Progress, name: str) -> typing.Iterator[Report]:
    """Yield a function that reports the completed fraction of a filter, in [0, 1].

    progress is False for no reports, True for a bar, or a function that gets each new fraction. The function
    is called on the thread that runs the filter's function, at most 50 times a second.
    """
    if not progress:
        yield lambda fraction: None
    elif callable(progress):
        with increasing(progress) as report:
            yield report
    else:
        with bar(name) as draw, increasing(draw) as report:
            yield report


@contextlib.contextmanager
def increasing(report: Report) -> typing.Iterator[Report]:
    """Yield a function that passes on each new fraction, and pass on 1 at the end unless there is an exception."""
    reached = -1.0

    def pass_on(fraction: float) -> None:
        nonlocal reached
        if fraction > reached:
            reached = fraction
            report(fraction)

    yield pass_on
    pass_on(1.0)


def of_percents(draw: typing.Callable[[int], object]) -> Report:
    """Return a function that draws a fraction in percent if that differs from what was drawn before.

    A notebook keeps all that was ever drawn.
    """
    drawn = -1

    def report(fraction: float) -> None:
        nonlocal drawn
        percent = round(100 * fraction)
        if percent != drawn:
            drawn = percent
            draw(percent)
    return report


@contextlib.contextmanager
def bar(name: str) -> typing.Iterator[Report]:
    """Yield a function that draws a fraction: a bar of tqdm if tqdm is installed, else one line."""
    try:
        from tqdm.auto import tqdm  # pylint: disable=import-outside-toplevel
    except ModuleNotFoundError:
        yield of_percents(lambda percent: print(f"\r{name} {percent:3} %", end="", file=sys.stderr, flush=True))
        print(file=sys.stderr)
        return
    with tqdm(total=100, desc=name, unit="%", bar_format="{l_bar}{bar}| {elapsed}") as drawn:
        def draw(percent: int) -> None:
            drawn.n = percent
            drawn.refresh()
        yield of_percents(draw)
