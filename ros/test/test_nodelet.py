#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Publishes a noisy plane to the running nodelet and checks what it publishes. Exit status 0 if all is correct."""

import sys

import dynamic_reconfigure.client
import numpy
import rospy
from sensor_msgs.msg import PointCloud2, PointField

WIDTH, HEIGHT, SPACING, NOISE = 80, 60, 0.01, 0.002
FIELDS = [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("gap", "V4"), ("rgb", "<u4"), ("intensity", "<f4"), ("ring", "<u2"),
          ("stamp", "<f8")]  # fmt: skip
TYPES = {"<f4": PointField.FLOAT32, "<u4": PointField.UINT32, "<u2": PointField.UINT16, "<f8": PointField.FLOAT64}


def noisy_plane():
    """An organised cloud with every kind of field and one invalid point."""
    random = numpy.random.default_rng(1)
    points = numpy.zeros(WIDTH * HEIGHT, dtype=FIELDS)
    points["x"] = SPACING * (numpy.arange(WIDTH * HEIGHT) % WIDTH)
    points["y"] = SPACING * (numpy.arange(WIDTH * HEIGHT) // WIDTH)
    points["z"] = 1 + random.normal(0, NOISE, WIDTH * HEIGHT)
    points["rgb"] = random.integers(0, 1 << 24, WIDTH * HEIGHT)
    points["intensity"] = random.random(WIDTH * HEIGHT)
    points["ring"] = numpy.arange(WIDTH * HEIGHT) % 64
    points["stamp"] = random.random(WIDTH * HEIGHT)
    points["z"][7] = numpy.nan
    return points


def message_of(points):
    message = PointCloud2(height=HEIGHT, width=WIDTH, is_bigendian=False, is_dense=False)
    message.header.frame_id = "camera_depth_optical_frame"
    message.header.stamp = rospy.Time(1234567890, 123456789)
    for name, kind in FIELDS:
        if name != "gap":
            message.fields.append(PointField(name, points.dtype.fields[name][1], TYPES[kind], 1))
    message.point_step = points.dtype.itemsize
    message.row_step = message.point_step * WIDTH
    message.data = points.tobytes()
    return message


def smoothed(publisher, message):
    """The nodelet's answer. Publishes repeatedly until one arrives, as nobody may be listening at first."""
    answers = []
    subscriber = rospy.Subscriber("/normal_smoothing/output", PointCloud2, answers.append)
    for _ in range(100):
        publisher.publish(message)
        rospy.sleep(0.2)
        if answers:
            subscriber.unregister()
            return answers[-1]
    sys.exit("the nodelet does not answer")


def deviation(points):
    return numpy.nanstd(points["z"].astype(float))


def check(condition, what):
    print(("ok: " if condition else "WRONG: ") + what)
    if not condition:
        sys.exit(1)


def main():
    rospy.init_node("test_nodelet")
    publisher = rospy.Publisher("/cloud", PointCloud2, queue_size=1)
    before = noisy_plane()
    sent = message_of(before)
    got = smoothed(publisher, sent)
    after = numpy.frombuffer(got.data, dtype=FIELDS)
    same = ("height", "width", "fields", "is_bigendian", "point_step", "row_step", "is_dense")
    check(got.header.frame_id == sent.header.frame_id, f"frame: {got.header.frame_id}")
    check(got.header.stamp == sent.header.stamp, f"stamp: {got.header.stamp}")
    check(all(getattr(got, name) == getattr(sent, name) for name in same), f"as it was: {', '.join(same)}")
    check(all((after[name] == before[name]).all() for name in before.dtype.names if name not in "xyz"), "all other fields")
    check(numpy.isnan(after["z"][7]) and not numpy.isnan(numpy.delete(after["z"], 7)).any(), "the point that is not there")
    check(deviation(after) < 0.4 * deviation(before), f"noise: {deviation(before):.5f} before, {deviation(after):.5f} after")

    client = dynamic_reconfigure.client.Client("/normal_smoothing", timeout=20)
    client.update_configuration({"max_displacement": 0.0001})
    capped = numpy.frombuffer(smoothed(publisher, sent).data, dtype=FIELDS)
    farthest = numpy.nanmax(numpy.abs(capped["z"] - before["z"]))
    check(0 < farthest < 0.000101, f"max_displacement 0.0001 set while it runs: {farthest:.6f}")
    client.update_configuration({"max_displacement": 0.0, "point_iterations": 0})
    still = numpy.frombuffer(smoothed(publisher, sent).data, dtype=FIELDS)
    check((still.tobytes() == before.tobytes()), "point_iterations 0: nothing moves, byte for byte")


if __name__ == "__main__":
    main()
