"""Reading, saving and comparing files; no Qt."""

from mocapmend.files.atomic import same_file
from mocapmend.files.c3d_encode import SampleRun
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_new import write_new_c3d
from mocapmend.files.c3d_patch import save_patched
from mocapmend.files.c3d_points import Way
from mocapmend.files.c3d_reader import C3DFile, read_c3d
from mocapmend.files.check import ChangedRun, CheckReport, check_files
from mocapmend.files.corrections import (
    NO_CORRECTIONS,
    Corrections,
    MovedRun,
    Renamed,
    SetAside,
    SmoothedRun,
)
from mocapmend.files.force_plate import ForcePlate
from mocapmend.files.formats import FORMATS, read_recording
from mocapmend.files.opening import Stamp
from mocapmend.files.provenance import Provenance
from mocapmend.files.records import KeptGap, RepairRecord
from mocapmend.files.saving import Saved
from mocapmend.files.second_reader import Claim
from mocapmend.files.source import Event, Source
from mocapmend.files.writing import LONG_CSV, WRITTEN, check_ending, patches, write_recording

__all__ = [
    "FORMATS",
    "LONG_CSV",
    "NO_CORRECTIONS",
    "WRITTEN",
    "C3DFile",
    "ChangedRun",
    "CheckReport",
    "Claim",
    "Corrections",
    "Event",
    "ForcePlate",
    "KeptGap",
    "Layout",
    "MovedRun",
    "Provenance",
    "Renamed",
    "RepairRecord",
    "SampleRun",
    "Saved",
    "SetAside",
    "SmoothedRun",
    "Source",
    "Stamp",
    "Way",
    "check_ending",
    "check_files",
    "patches",
    "read_c3d",
    "read_recording",
    "same_file",
    "save_patched",
    "write_new_c3d",
    "write_recording",
]
