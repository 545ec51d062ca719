"""Small text files as the programs write them, with numbers made up here, and recordings."""

import numpy as np
from hypothesis import strategies as st

from mocapmend.files.formats.columns import clean_label
from mocapmend_algorithms.recording import MM_PER_UNIT, Recording

TRC = """\
PathFileType\t4\t(X/Y/Z)\twalk.trc
DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames
120.00\t120.00\t3\t2\tmm\t120.00\t1\t3
Frame#\tTime\tLASI\t\t\tR.ASI\t\t\t
\t\tX1\tY1\tZ1\tX2\tY2\tZ2\t

11\t0.083333\t1.5\t2.5\t3.5\t-4.25\t5\t6\t
12\t0.091667\t1.6\t2.6\t3.6\t\t\t\t
13\t0.100000\t1.7\t2.7\t3.7\tNaN\tNaN\tNaN\t
"""

QUALISYS = """\
NO_OF_FRAMES\t3
NO_OF_CAMERAS\t8
NO_OF_MARKERS\t2
FREQUENCY\t200
NO_OF_ANALOG\t0
ANALOG_FREQUENCY\t0
DESCRIPTION\t--
TIME_STAMP\t2024-05-06, 10:11:12.345\t94247.45402301
DATA_INCLUDED\t3D
EVENT\tToe off\t3\t0.01
EVENT\tHeel strike\t2\t0.005
MARKER_NAMES\thead top\tL_wrist
TRAJECTORY_TYPES\tMeasured\tMixed
"""
QUALISYS_ROWS = (
    "1.5\t2.5\t3.5\t-4\t5\t6",
    "1.6\t2.6\t3.6\t0.000\t0.000\t0.000",
    "\t\t\t-4.2\t5.2\t6.2",
)

MOTIVE = """\
Format Version,1.23,Take Name,"Take, one",Take Notes,,Capture Frame Rate,240.000000,\
Export Frame Rate,120.000000,Capture Start Time,2024-05-06 10.11.12.345 AM,Capture Start Frame,0,\
Total Frames in Take,6,Total Exported Frames,3,Rotation Type,Quaternion,\
Length Units,Meters,Coordinate Space,Global

,Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,\
Rigid Body Marker,Rigid Body Marker,Rigid Body Marker,Rigid Body Marker,Marker,Marker,Marker
,Name,Club,Club,Club,Club,Club,Club,Club,Club,\
"Club:Marker1","Club:Marker1","Club:Marker1","Club:Marker1",Club:Marker1,Club:Marker1,Club:Marker1
,ID,"A1","A1","A1","A1","A1","A1","A1","A1","B1","B1","B1","B1","C1","C1","C1"
,,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Mean Marker Error,\
Position,Position,Position,Marker Quality,Position,Position,Position
Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,,X,Y,Z,,X,Y,Z
0,0.000000,0.1,0.2,0.3,0.9,1,2,3,0.0001,1.5,2.5,3.5,1.0,1.6,2.6,3.6
1,0.008333,,,,,,,,,1.7,2.7,3.7,,,,
2,0.016667,0.1,0.2,0.3,0.9,1,2,3,0.0001,1.9,2.9,3.9,1.0,1.8,2.8,3.8
"""

NEXUS = """\
Devices
1000
,,Force plate - Force,,
Frame,Sub Frame,Fx,Fy,Fz
,,N,N,N
101,0,1,2,3
101,1,1,2,3

Trajectories
100
,,Ann:LASI,,,Ann:RASI,,
Frame,Sub Frame,X,Y,Z,X,Y,Z
,,mm,mm,mm,mm,mm,mm
101,0,1.5,2.5,3.5,-4,5,6
102,0,1.6,2.6,3.6,,,
103,0,1.7,2.7,3.7,-4.2,5.2,6.2

Model Outputs
100
,,Ann:LHipAngles,,
Frame,Sub Frame,X,Y,Z
,,deg,deg,deg
101,0,9,9,9
"""

WIDE = """\
frame,time,LASI_x,LASI_y,LASI_z,R ASI_x,R ASI_y,R ASI_z
1,0.00,1.5,2.5,3.5,-4,5,6
2,0.02,1.6,2.6,3.6,,,
3,0.04,1.7,2.7,3.7,-4.2,5.2,6.2
"""

LONG = """\
frame,time,marker,x,y,z
1,0.00,LASI,1.5,2.5,3.5
1,0.00,R ASI,-4,5,6
2,0.02,LASI,1.6,2.6,3.6
2,0.02,R ASI,,,
3,0.04,LASI,1.7,2.7,3.7
3,0.04,R ASI,-4.2,5.2,6.2
"""

NAN = np.nan
POINTS = np.array(
    [
        [[1.5, 2.5, 3.5], [-4, 5, 6]],
        [[1.6, 2.6, 3.6], [NAN, NAN, NAN]],
        [[1.7, 2.7, 3.7], [-4.2, 5.2, 6.2]],
    ]
)
"""What most of the samples hold."""

LABELS = st.text(min_size=1, max_size=12).filter(lambda text: clean_label(text) == text)
NUMBERS = st.floats(-1e6, 1e6) | st.floats(-1e-300, 1e-300)


@st.composite
def recordings(draw: st.DrawFn, *, units: tuple[str, ...] = tuple(MM_PER_UNIT)) -> Recording:
    """Draw small recordings with gaps, repeated and strange labels."""
    frames, markers = draw(st.integers(0, 5)), draw(st.integers(1, 4))
    labels = draw(st.lists(LABELS, min_size=markers, max_size=markers))
    if draw(st.booleans()):
        labels[-1] = labels[0]
    count = frames * markers
    numbers = draw(st.lists(NUMBERS, min_size=3 * count, max_size=3 * count))
    points = np.array(numbers, float).reshape(frames, markers, 3)
    missing = draw(st.lists(st.booleans(), min_size=count, max_size=count))
    points[np.array(missing, bool).reshape(frames, markers)] = np.nan
    return Recording(
        points,
        tuple(labels),
        draw(st.sampled_from([25.0, 59.94, 100.0, 120.0]) | st.floats(0.5, 5000)),
        unit=draw(st.sampled_from(units)),
        up=draw(st.sampled_from(["+x", "-x", "+y", "-y", "+z", "-z"])),
        first_frame=draw(st.integers(-3, 3) | st.integers(0, 10**6)),
    )


def assert_same(back: Recording, recording: Recording, *, up: bool = True) -> None:
    """Compare everything that a file keeps."""
    np.testing.assert_array_equal(back.points, recording.points)
    assert back.labels == recording.labels
    assert (back.rate, back.unit) == (recording.rate, recording.unit)
    assert back.up == recording.up or not up
    if recording.frames:
        assert back.first_frame == recording.first_frame
