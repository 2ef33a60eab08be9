#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The module of 3D Slicer, without Slicer: that it compiles, what it decodes, and its curve. What it decodes of a running
insertion is in navigation_test.py. A scene of plain objects stands for Slicer where it places what has come."""

import importlib.util
import py_compile
import sys
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True  # nothing beside what is installed
FILE = Path(__file__).resolve().parents[3] / "resources/slicer/PerilymphInsertion.py"


def load():
    spec = importlib.util.spec_from_file_location("PerilymphInsertion", FILE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def values(time, depth, force):
    return {"time_s": time, "depth_mm": depth, "force_axial_N": force}


class Decoding(unittest.TestCase):
    def setUp(self):
        self.module = load()

    def test_it_compiles_and_is_named_as_slicer_expects(self):
        with tempfile.TemporaryDirectory() as folder:
            py_compile.compile(str(FILE), cfile=str(Path(folder) / "module.pyc"), doraise=True)
        for suffix in ("", "Widget", "Logic"):
            self.assertTrue(isinstance(getattr(self.module, FILE.stem + suffix), type))

    def test_a_readout_is_numbers_by_name_and_the_frame(self):
        text = "time_s=1.5\nforce_axial_N=-2.5e-3\ncoordinates=patient\npatient=known\n"
        self.assertEqual(self.module.readout(text),
                         {"time_s": 1.5, "force_axial_N": -0.0025, "coordinates": "patient", "patient": "known"})
        self.assertEqual(self.module.readout(""), {})

    def test_what_is_no_readout_is_refused_with_a_sentence(self):
        with self.assertRaisesRegex(ValueError, "'force 3' of PerilymphReadout is not of the form"):
            self.module.readout("time_s=1\nforce 3")
        with self.assertRaisesRegex(ValueError, "time_s of PerilymphReadout is 'x'"):
            self.module.readout("time_s=x")

    def test_a_place_is_turned_and_then_moved(self):
        # x to y, y to -x, as a quarter turn about z
        rows = ((0, -1, 0, 10), (1, 0, 0, 20), (0, 0, 1, 30), (0, 0, 0, 1))
        self.assertEqual(self.module.moved(rows, (1, 2, 3)), (8, 21, 33))
        self.assertEqual(self.module.force_of(rows), (10, 20, 30))

    def test_the_curve_begins_again_with_another_insertion(self):
        curve = self.module.ForceCurve()
        for time, depth, force in ((0.0, 1.0, 0.01), (0.02, 1.1, 0.03), (0.02, 1.1, 0.03), (0.04, 1.2, 0.02)):
            curve.add(values(time, depth, force))
        self.assertEqual(curve.points, [(1.0, 0.01), (1.1, 0.03), (1.2, 0.02)])
        self.assertEqual(curve.peak_N, 0.03)
        curve.add(values(0.0, 0.5, 0.0))
        self.assertEqual((curve.points, curve.peak_N), ([(0.5, 0.0)], 0.0))

    def test_a_long_curve_is_thinned_out_and_keeps_its_peak(self):
        curve = self.module.ForceCurve()
        for i in range(100_000):
            curve.add(values(0.02 * i, 1e-4 * i, 0.5 if i == 77_777 else 0.1))
        self.assertLess(len(curve.points), curve.MAX_POINTS)
        self.assertGreater(len(curve.points), curve.MAX_POINTS // 4)
        self.assertEqual(curve.points, sorted(curve.points, key=lambda point: point[0]))
        self.assertEqual(curve.peak_N, 0.5)


class Node:
    """A node of the scene: keeps what it is told."""

    def __init__(self, name):
        self.name, self.parent, self.text, self.style = name, None, "", {}

    def GetID(self):
        return "ID of " + self.name

    def GetTransformNodeID(self):
        return self.parent

    def SetAndObserveTransformNodeID(self, identity):
        self.parent = identity

    def GetDisplayNode(self):
        return self

    def GetText(self):
        return self.text

    def __getattr__(self, name):  # SetOpacity(0.25) and the like
        if not name.startswith("Set"):
            raise AttributeError(name)
        return lambda *value: self.style.__setitem__(name, value)


class Placing(unittest.TestCase):
    def setUp(self):
        self.nodes = {}
        slicer = mock.MagicMock()
        slicer.util.getFirstNodeByClassByName = lambda kind, name: self.nodes.get((kind, name))
        base = types.ModuleType("slicer.ScriptedLoadableModule")
        for name in ("ScriptedLoadableModule", "ScriptedLoadableModuleLogic", "ScriptedLoadableModuleWidget"):
            setattr(base, name, type(name, (), {"__init__": lambda self, *_: None}))
        util = types.ModuleType("slicer.util")
        util.VTKObservationMixin = type("VTKObservationMixin", (), {
            "__init__": lambda self: None,
            "addObserver": lambda self, node, event, call: setattr(node, "changed", call),
            "removeObservers": lambda self, call=None: None})
        modules = {"slicer": slicer, "slicer.util": util, "slicer.ScriptedLoadableModule": base}
        modules.update({name: mock.MagicMock() for name in ("ctk", "qt", "vtk")})
        with mock.patch.dict(sys.modules, modules):
            self.module = load()
        self.slicer = slicer
        self.logic = self.module.PerilymphInsertionLogic()

    def add(self, kind, name):
        self.nodes[kind, name] = Node(name)
        return self.nodes[kind, name]

    def test_everything_that_has_come_is_moved_to_the_patient_but_the_force(self):
        placed = [self.add(kind, name) for name, kind, _, _ in self.module.PLACED]
        force = self.add("vtkMRMLLinearTransformNode", self.module.FORCE)
        patient = self.add("vtkMRMLLinearTransformNode", self.module.TO_PATIENT)
        self.logic.refresh()
        self.assertEqual({node.parent for node in placed}, {None})  # the patient is not known
        self.slicer.util.setSliceViewerLayers.assert_not_called()
        text = self.add("vtkMRMLTextNode", self.module.READOUT)
        text.text = "time_s=0\ndepth_mm=1\nforce_axial_N=0\npatient=known\n"
        self.logic.refresh()
        self.assertEqual({node.parent for node in placed}, {patient.GetID()})
        self.assertIsNone(force.parent)  # newtons, no place
        self.assertEqual(self.nodes["vtkMRMLModelNode", "PerilymphScala"].style["SetOpacity"], (0.25,))
        self.slicer.util.setSliceViewerLayers.assert_called_once()
        # The cochlea of another patient, whose CT is not open, is not over this CT.
        text.text = "time_s=0\ndepth_mm=1\nforce_axial_N=0\npatient=unknown\n"
        text.changed()
        self.logic.refresh()
        self.slicer.util.setSliceViewerLayers.assert_called_with(background=None)
        self.assertEqual({node.parent for node in placed if node.name != self.module.CT}, {None})

    def test_every_text_is_a_point_of_the_curve(self):
        text = self.add("vtkMRMLTextNode", self.module.READOUT)
        text.text = "time_s=0\ndepth_mm=1\nforce_axial_N=0.01\n"
        self.logic.refresh()
        text.text = "time_s=0.02\ndepth_mm=1.1\nforce_axial_N=0.02\n"
        text.changed()
        self.assertEqual(self.logic.curve.points, [(1.0, 0.01), (1.1, 0.02)])
        text.text = "nonsense"
        text.changed()
        self.assertIn("not of the form", self.logic.error)
        self.logic.refresh()
        # One mock stands for both columns: depth [mm] and force [mN] by turns.
        depth, _ = self.logic._columns
        self.assertEqual([call.args[0] for call in depth.InsertNextValue.call_args_list], [1.0, 10.0, 1.1, 20.0])
        self.logic._onSceneClosed()
        self.assertEqual(self.logic.curve.points, [])

    def test_what_slicer_does_not_show_is_skipped_once_all_the_rest_has_come(self):
        self.logic.connect("localhost", 18944)
        for name, kind, _, _ in self.module.PLACED:
            self.add(kind, name)
        self.add("vtkMRMLTextNode", self.module.READOUT)
        self.add("vtkMRMLLinearTransformNode", self.module.FORCE)
        self.logic.refresh()
        self.logic.connector.SetRestrictDeviceName.assert_not_called()  # it would skip the transform to the patient
        self.add("vtkMRMLLinearTransformNode", self.module.TO_PATIENT)
        self.logic.refresh()
        self.logic.refresh()
        self.logic.connector.SetRestrictDeviceName.assert_called_once_with(1)

    def test_it_connects_as_a_client(self):
        self.logic.connect("localhost", 18944)
        self.slicer.mrmlScene.AddNewNodeByClass.assert_called_once_with("vtkMRMLIGTLConnectorNode", "Perilymph")
        self.logic.connector.SetTypeClient.assert_called_once_with("localhost", 18944)
        self.logic.connector.Start.assert_called_once()
        del self.slicer.vtkMRMLIGTLConnectorNode
        with self.assertRaisesRegex(RuntimeError, "SlicerOpenIGTLink"):
            self.logic.connect("localhost", 18944)


if __name__ == "__main__":
    unittest.main()
