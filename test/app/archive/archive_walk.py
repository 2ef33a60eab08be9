# SPDX-License-Identifier: BSD-3-Clause
"""The functions of perilymph.archive with a server: archive_walk.py SERVER FOLDER IMAGES. Run by ArchiveTest.cpp, which starts it."""

import os
import sys

import perilymph
from perilymph import archive

server, folder, images = sys.argv[1], sys.argv[2], int(sys.argv[3])


def refused(call, text):
    try:
        call()
    except perilymph.Error as error:
        assert text in str(error), error
        return
    raise AssertionError(f"not refused: {text}")


assert archive.servers() == [server]
archive.test(server)
refused(lambda: archive.find(server), "condition")
refused(lambda: archive.find(server, birth_date="19701301"), "is no date of the calendar")
assert archive.find(server, patient_id="NOBODY") == []

study, = archive.find(server, patient_id="SECRET*", modality="CT")
assert study.uid == "1.2.3" and study.patient_id is None and study.patient_name is None
named, = archive.find(server, patient_id="SECRET*", show_patients=True)
assert named.patient_id == "SECRETID" and named.birth_date == "19010203"

series, = archive.find_series(server, study)
assert series == archive.find_series(server, "1.2.3")[0]
assert series.modality == "CT" and series.images in (images, None)

ct = archive.retrieve(server, series, folder)
assert (ct.images, ct.resumed, ct.obstacle) == (images, 0, ""), ct
assert len(os.listdir(folder)) == images and os.stat(folder).st_mode & 0o777 == 0o700
refused(lambda: archive.retrieve(server, series, folder), "it is a folder")
refused(lambda: archive.retrieve(server, archive.Series("1.2.3", "9.9.9"), folder + "-other"), "9.9.9")
assert not os.path.exists(folder + "-other")
refused(lambda: archive.send(server, os.path.join(folder, os.listdir(folder)[0])), "is no result of this program")
