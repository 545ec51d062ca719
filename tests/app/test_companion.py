"""Another recording beside a document: frames, unit, axes, lag, and who belongs to whom."""

import gzip
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode
from kinect_samples import REST_25, person, rows
from refine_networks import write_kinect22, write_network
from scipy.spatial.transform import Rotation

from mocapmend import companion
from mocapmend.beside import bring
from mocapmend.companion import partners_of
from mocapmend.errors import MocapmendError
from mocapmend.files import Provenance, read_recording
from mocapmend.files.sidecar import hash_file
from mocapmend.refine.apart import Order, carry_out
from mocapmend.refine.judging import judge
from mocapmend.refine.profiles import profile_named
from mocapmend.views.engine_texts import find
from mocapmend_algorithms import Cancelled, Recording, no_progress
from mocapmend_algorithms.refine.refining import RefineParams

LABELS = ("Head", "LeftHand", "RightHand", "Foot")
REST = np.array([[0, 0, 1700], [600, 50, 1200], [-600, -20, 1100], [120, 300, 80]], float)


def waving(times: np.ndarray) -> np.ndarray:
    """Return four points of a body that moves smoothly, shape (times, 4, 3)."""
    phase = np.arange(12).reshape(4, 3)
    return REST + 150 * np.sin(2 * np.pi * (0.4 + 0.05 * phase) * times[:, None, None] + phase)


def recording(
    points: np.ndarray, labels: tuple[str, ...] = LABELS, rate: float = 60.0
) -> Recording:
    return Recording(np.ascontiguousarray(points), labels, rate)


@pytest.fixture
def own() -> Recording:
    return recording(waving(np.arange(180) / 60.0))


def test_what_it_was_made_from_stays_where_it_is(own: Recording) -> None:
    # z up becomes y up by (x, y, z) -> (x, z, -y).
    stored = own.points[..., [0, 2, 1]] * [1, 1, -1] / 1000
    metres = Recording(np.ascontiguousarray(stored), LABELS, 60.0, unit="m", up="+y")
    found, way, lag = bring(own, metres, no_progress, origin=True)
    assert (way, lag) == ("origin", 0.0)
    assert (found.unit, found.up, found.rate) == ("mm", "+z", 60.0)
    np.testing.assert_allclose(found.points, own.points, atol=1e-9)


def test_another_rate_is_sampled_between_its_frames(own: Recording) -> None:
    times = np.arange(100) / 25.0
    straight = REST + times[:, None, None] * [100.0, -50.0, 10.0]
    found, _, _ = bring(own, recording(straight, rate=25.0), no_progress, origin=True)
    expected = REST + np.arange(180)[:, None, None] / 60.0 * [100.0, -50.0, 10.0]
    np.testing.assert_allclose(found.points, expected, atol=1e-9)


def test_frames_that_are_in_both_are_taken_as_they_are(own: Recording) -> None:
    rng = np.random.default_rng(1)
    rough = rng.normal(size=(360, 4, 3))
    found, _, _ = bring(own, recording(rough, rate=120.0), no_progress, origin=True)
    np.testing.assert_array_equal(found.points, rough[::2])


def test_there_is_nothing_outside_and_beside_what_is_missing(own: Recording) -> None:
    times = np.arange(30) / 30.0
    points = waving(times)
    points[10, 1] = np.nan
    points[:, 2] = np.nan
    found, _, _ = bring(own, recording(points, rate=30.0), no_progress, origin=True)
    missing = np.isnan(found.points[..., 0])
    # Frame 10 of 30 per second is frame 20 of 60; what lies between it and its neighbours goes too.
    assert np.flatnonzero(missing[:59, 1]).tolist() == [19, 20, 21]
    assert missing[59:].all(), "it ends in frame 29, which is 58"
    assert missing[:, 2].all()
    assert not missing[:59, [0, 3]].any()


@pytest.mark.parametrize("lag", [-0.5, 0.0, 0.25])
@pytest.mark.parametrize("rate", [60.0, 100.0])
def test_lag_turn_and_shift_are_found(own: Recording, lag: float, rate: float) -> None:
    """What the other shows at a time, this one shows a lag later."""
    turn = Rotation.from_euler("ZXY", [70.0, 10.0, -20.0], degrees=True).as_matrix()
    count = round(4 * rate)
    theirs = (waving(np.arange(count) / rate + lag) - [100.0, 900.0, -300.0]) @ turn.T
    named = tuple(f"Anna:{name.upper()}" for name in LABELS)
    found, way, seconds = bring(own, recording(theirs, named, rate), no_progress)
    assert way == "fitted"
    assert seconds == pytest.approx(lag, abs=1e-9)
    there = ~np.isnan(found.points[..., 0])
    assert there.sum() >= 4 * 150
    np.testing.assert_allclose(found.points[there], own.points[there], atol=0.2)


def test_a_gap_of_either_does_not_spoil_the_fit(own: Recording) -> None:
    holed, theirs = own.points.copy(), own.points + np.array([500.0, 0.0, 0.0])
    holed[:5, 0] = np.nan
    theirs[100:110, 3] = np.nan
    found, way, _ = bring(recording(holed), recording(theirs), no_progress)
    assert way == "fitted"
    there = ~np.isnan(found.points[..., 0])
    np.testing.assert_allclose(found.points[there], own.points[there], atol=1e-6)


def test_two_common_labels_are_too_few(own: Recording) -> None:
    theirs = recording(own.points + 500.0, ("Head", "LeftHand", "A", "B"))
    found, way, lag = bring(own, theirs, no_progress)
    assert (way, lag) == ("as it is", 0.0)
    np.testing.assert_array_equal(found.points, own.points + 500.0)


def test_too_little_time_in_common_is_told(own: Recording) -> None:
    found, way, _ = bring(own, recording(own.points[:20] + 500.0), no_progress)
    assert way == "as it is"
    assert np.isnan(found.points[20:]).all()


def test_it_can_be_broken_off(own: Recording) -> None:
    def cancel(_: float) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        bring(own, own, cancel)


def test_partners_are_of_the_same_label_else_near() -> None:
    points = np.tile(REST, (50, 1, 1))
    ours = recording(points, ("Anna:HEAD", "LWRA", "RWRA", "gone"))
    ours.points.flags.writeable = True
    ours.points[:, 3] = np.nan
    # The label counts, however far away it is.
    theirs = points[:, [1, 2, 0]] + [5.0, 0.0, 0.0]
    other = recording(theirs + 0.0, ("LeftWrist", "RightWrist", "Head"))
    other.points.flags.writeable = True
    other.points[:, 2] += 3000.0
    assert partners_of(ours, other) == (2, 0, 1, None)


def test_a_label_that_is_there_twice_is_no_partner() -> None:
    points = np.tile(REST, (10, 1, 1))
    other = recording(points[:, [1, 0]] + 0.0, ("HEAD", "Head"))
    assert partners_of(recording(points), other)[0] == 1, "the nearer one"


def test_a_partner_is_near_on_average() -> None:
    track = np.zeros((40, 1, 3))
    near = np.zeros((40, 2, 3))
    near[:, 0, 0] = 10.0
    near[:30, 1, 0], near[30:, 1, 0] = 0.0, 100.0
    assert partners_of(recording(track, ("A",)), recording(near, ("B", "C"))) == (0,)


# --- files ---------------------------------------------------------------------------------------


def test_the_original_is_known_by_what_is_in_the_file(tmp_path: Path) -> None:
    joints, network = write_kinect22(tmp_path), write_network(tmp_path / "net.npz")
    source = read_recording(joints)
    out = tmp_path / "refined.c3d"
    order = Order(joints, source.stamp, str(network), RefineParams(), out)
    carry_out(order, no_progress)
    refined = read_recording(out)
    found = companion.load(refined.recording, refined.provenance, joints, no_progress)
    assert found.way == "origin"
    assert found.bones == source.bones
    assert found.judged is None, "it has not the markers that came out"
    # In a C3D file numbers have 32 bits.
    np.testing.assert_allclose(found.points, source.recording.points, atol=1e-3)
    labels = refined.recording.labels
    partner = found.partners[labels.index("LELB")]
    assert partner is not None
    assert source.recording.labels[partner] == "LeftElbow"
    same = companion.load(refined.recording, refined.provenance, out, no_progress)
    assert same.judged is not None
    assert same.judged.refined.position == pytest.approx(0.0, abs=1e-9)
    assert same.way == "fitted"


def test_any_input_of_a_record_is_an_original(tmp_path: Path) -> None:
    path = tmp_path / "v2.csv"
    path.write_text(rows(person(40, REST_25)))
    own = read_recording(path).recording
    record = Provenance((), ("0" * 64, hash_file(path)))
    assert companion.load(own, record, path, no_progress).way == "origin"
    assert companion.load(own, None, path, no_progress).way == "fitted"


def test_nothing_to_compare_with_is_told(tmp_path: Path, own: Recording) -> None:
    empty = tmp_path / "analog.c3d"
    analog = np.zeros((10, 4, 2))
    empty.write_bytes(encode(Synthetic(np.zeros((10, 0, 3)), analog=analog)))
    with pytest.raises(MocapmendError) as caught:
        companion.load(own, None, empty, no_progress)
    assert caught.value.what == "This recording has no markers to compare with."
    assert find(caught.value.what) is not None
    assert find(caught.value.todo) is not None


# --- references ----------------------------------------------------------------------------------


def markers(seed: int = 0, frames: int = 150) -> Recording:
    """Return the 39 markers of the profile, moving smoothly, at 60 per second."""
    outputs = profile_named("kinect22-pig39").outputs
    rng = np.random.default_rng(seed)
    rest, phase = rng.normal(0, 400, (39, 3)), rng.uniform(0, 6, (39, 3))
    times = np.arange(frames)[:, None, None] / 60.0
    return recording(rest + 80 * np.sin(3 * times + phase), outputs)


def test_a_reference_that_is_turned_and_late_is_no_error() -> None:
    made = markers()
    turn = Rotation.from_euler("z", 40.0, degrees=True).as_matrix()
    late = recording(made.points[12:] @ turn.T + 77.0, made.labels)
    found = judge(made, late, "kinect22-pig39", "late.c3d")
    assert found is not None
    assert found.lag == pytest.approx(0.2)
    assert found.refined.position == pytest.approx(0.0, abs=1e-9)
    assert max(mm for _, mm in found.rms) == pytest.approx(0.0, abs=1e-4)
    assert found.refined.smoothness == pytest.approx(found.truth.smoothness, rel=1e-9)


def test_an_error_of_one_marker_is_found_at_it() -> None:
    made = markers()
    place = made.labels.index("LWRA")
    points = made.points.copy()
    points[:, place, 2] += np.where(np.arange(150) % 2, 30.0, -30.0)
    found = judge(recording(points, made.labels), made, "kinect22-pig39", "r.c3d")
    assert found is not None
    errors = dict(found.rms)
    assert errors.pop("LWRA") == pytest.approx(30.0, rel=0.01)
    assert max(errors.values()) < 2.0
    assert found.refined.position == pytest.approx(900.0 / (39 * 3), rel=0.05)


def test_what_is_no_reference_gives_no_figures() -> None:
    made = markers()
    others = replace(made, labels=tuple(f"M{k}" for k in range(39)))
    assert judge(made, others, "kinect22-pig39", "r.c3d") is None
    assert judge(made, made, "of their own", "r.c3d") is None
    assert judge(others, made, "kinect22-pig39", "r.c3d") is None
    assert judge(made, recording(made.points[:20], made.labels), "kinect22-pig39", "") is None


def test_a_real_reference_fits_what_was_made_of_its_kinect(shared: Path, tmp_path: Path) -> None:
    for packed in (shared / "kinect" / "uiprmd_raw_samples").glob("*m07_s04_e03*.gz"):
        (tmp_path / packed.stem).write_bytes(gzip.decompress(packed.read_bytes()))
    joints = tmp_path / "kinect_positions__m07_s04_e03.txt"
    network, out = write_network(tmp_path / "net.npz"), tmp_path / "refined.c3d"
    order = Order(joints, read_recording(joints).stamp, str(network), RefineParams("60", 6.0), out)
    carry_out(order, no_progress)
    refined = read_recording(out)
    reference = tmp_path / "vicon_positions__m07_s04_e03.txt"
    found = companion.load(refined.recording, refined.provenance, reference, no_progress)
    assert found.way == "fitted"
    assert found.partners == tuple(range(39))
    assert found.judged is not None
    # Joints stand for the markers beside them: they lie in the body, not on the skin.
    elbow, other = (refined.recording.labels.index(name) for name in ("LELB", "RELB"))
    off = np.linalg.norm(found.points - refined.recording.points, axis=2)[:, [elbow, other]]
    assert np.nanmedian(off) < 150.0
