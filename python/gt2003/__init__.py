"""GT2003 from Python: matches of simulated robots, their values, and their modules.

See docs/python.md of the project.
"""

from ._error import Error
from . import representations
from . import modules
from . import colors, jobs, logs, motions, xabsl
from ._core import Match, Robot
from ._solution import Previous, SolutionFailure
from .logs import Log

__all__ = [
    "Error",
    "Log",
    "Match",
    "Previous",
    "Robot",
    "SolutionFailure",
    "colors",
    "jobs",
    "logs",
    "modules",
    "motions",
    "representations",
    "xabsl",
]
