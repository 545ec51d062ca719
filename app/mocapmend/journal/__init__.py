"""The journal: edits that are not exported yet, on the disk before they are made.

One file per recording that is being edited. After a crash it is all that is left of the edits; when
the recording is closed it goes.
"""

from mocapmend.journal.abandoned import Abandoned, discard, find_abandoned
from mocapmend.journal.history import History
from mocapmend.journal.recorder import Recorder
from mocapmend.journal.replay import resume

__all__ = ["Abandoned", "History", "Recorder", "discard", "find_abandoned", "resume"]
