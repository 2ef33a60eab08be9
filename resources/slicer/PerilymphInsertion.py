# SPDX-License-Identifier: BSD-3-Clause
"""A module of 3D Slicer that shows a running insertion of Perilymph: array, contacts and scalae over the patient's CT, and
the insertion force over depth.

Needs the extension SlicerOpenIGTLink, whose connector receives the messages. What is sent, and under which names, is
documented in the guide of Perilymph (navigation.md). The functions and ForceCurve need no Slicer."""

try:
    import ctk
    import qt
    import slicer
    import vtk
    from slicer.ScriptedLoadableModule import ScriptedLoadableModule, ScriptedLoadableModuleLogic, ScriptedLoadableModuleWidget
    from slicer.util import VTKObservationMixin
except ImportError:  # outside Slicer
    slicer = None

    class ScriptedLoadableModule:
        pass

    class VTKObservationMixin:
        pass

    ScriptedLoadableModuleWidget = ScriptedLoadableModuleLogic = ScriptedLoadableModule


READOUT = "PerilymphReadout"
FORCE = "PerilymphForceXYZ"
TO_PATIENT = "PerilymphToPatient"
CT = "PerilymphCT"
TIP = "PerilymphTip"
# What is in the coordinates that are sent: name, class, and for models color and opacity.
PLACED = (
    ("PerilymphTip", "vtkMRMLLinearTransformNode", None, None),
    ("PerilymphTweezers", "vtkMRMLLinearTransformNode", None, None),
    ("PerilymphContacts", "vtkMRMLMarkupsFiducialNode", None, None),
    ("PerilymphArray", "vtkMRMLModelNode", (0.95, 0.95, 0.98), 1.0),
    ("PerilymphScala", "vtkMRMLModelNode", (0.45, 0.70, 0.90), 0.25),
    ("PerilymphVestibuli", "vtkMRMLModelNode", (0.80, 0.70, 0.90), 0.12),
    (CT, "vtkMRMLScalarVolumeNode", None, None),
)
TEXTS = ("coordinates", "patient")
REFRESH_MS = 100  # of plot and display; the force is kept at the rate at which it comes


def readout(text):
    """The values of a STRING PerilymphReadout by name: numbers, and the texts of TEXTS. Names of numbers end in their unit.

    Raises ValueError with a sentence if a line has no value, or one that is no number."""
    values = {}
    for line in text.splitlines():
        name, separator, value = line.partition("=")
        if not separator or not name:
            raise ValueError(f"The line '{line}' of {READOUT} is not of the form name=value.")
        if name in TEXTS:
            values[name] = value
            continue
        try:
            values[name] = float(value)
        except ValueError:
            raise ValueError(f"{name} of {READOUT} is '{value}'; it must be a number.") from None
    return values


def force_of(rows):
    """The force on the hand (x, y, z) [N] of the matrix of PerilymphForceXYZ: its translation, in newtons."""
    return tuple(row[3] for row in rows[:3])


def moved(rows, place):
    """A place (x, y, z) behind a matrix of four rows, such as that of PerilymphToPatient [mm]."""
    return tuple(sum(row[i] * place[i] for i in range(3)) + row[3] for row in rows[:3])


class ForceCurve:
    """Insertion force over insertion depth since the start of an insertion."""

    MAX_POINTS = 20000  # choice: 400 s at 50 a second; then every second one is dropped

    def __init__(self):
        self.points = []  # depth [mm], force [N]
        self.peak_N = 0.0
        self._time = -1.0
        self._stride = 1
        self._skipped = 0

    def add(self, values):
        """Takes a readout(). A time that runs backward is another insertion: the curve begins again."""
        time, depth, force = values["time_s"], values["depth_mm"], values["force_axial_N"]
        if time < self._time:
            self.__init__()
        if time == self._time:
            return  # a pause
        self._time = time
        self.peak_N = max(self.peak_N, force)
        self._skipped += 1
        if self._skipped < self._stride:
            return
        self._skipped = 0
        self.points.append((depth, force))
        if len(self.points) >= self.MAX_POINTS:
            del self.points[::2]
            self._stride *= 2


class PerilymphInsertion(ScriptedLoadableModule):
    """Registers the module."""

    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        self.parent.title = "Perilymph insertion"
        self.parent.categories = ["IGT"]
        self.parent.dependencies = []
        self.parent.contributors = ["Perilymph"]
        self.parent.helpText = (
            "Shows a running insertion of a cochlear-implant array: Perilymph, Settings, Stream to 3D Slicer (OpenIGTLink). "
            "Needs the extension SlicerOpenIGTLink. Not a medical device."
        )
        self.parent.acknowledgementText = ""


class PerilymphInsertionLogic(ScriptedLoadableModuleLogic, VTKObservationMixin):
    """Connects, keeps the force, and places what is received."""

    def __init__(self):
        ScriptedLoadableModuleLogic.__init__(self)
        VTKObservationMixin.__init__(self)
        self.addObserver(slicer.mrmlScene, slicer.mrmlScene.EndCloseEvent, self._onSceneClosed)
        self._begin()

    def _begin(self):
        self.curve = ForceCurve()
        self.values = {}
        self.error = ""
        self.connector = None
        self._text = None
        self._isRestricted = False
        self._styled = set()
        self._shown = 0
        self._columns = None
        self._table = None

    def _onSceneClosed(self, caller=None, event=None):
        self.removeObservers(self._onReadout)
        self._begin()

    def connect(self, host, port):
        """Connects to a Perilymph; it may be started later."""
        if not hasattr(slicer, "vtkMRMLIGTLConnectorNode"):
            raise RuntimeError("Install the extension SlicerOpenIGTLink with the Extensions Manager, and restart Slicer.")
        if self.connector is None:
            self.connector = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLIGTLConnectorNode", "Perilymph")
        self.connector.SetTypeClient(host, port)
        self.connector.Start()

    def disconnect(self):
        if self.connector is not None:
            self.connector.Stop()

    def isConnected(self):
        return self.connector is not None and self.connector.GetState() == slicer.vtkMRMLIGTLConnectorNode.StateConnected

    def close(self):
        """Ends the connection and observes nothing."""
        self.disconnect()
        self.removeObservers()
        self._text = None

    @staticmethod
    def node(name, kind):
        return slicer.util.getFirstNodeByClassByName(kind, name)

    def isInPatient(self):
        """Whether the CT and the transform to the patient are those of the cochlea that is shown."""
        return self.values.get("patient") == "known"

    def refresh(self):
        """Places and styles what has come since, and updates the plot."""
        self._observeReadout()
        self._place()
        self._restrict()
        self._plot()

    def tip(self):
        """Where the tip is in Slicer's scene (RAS) [mm]; None before it came."""
        transform = self.node(TIP, "vtkMRMLLinearTransformNode")
        if transform is None:
            return None
        matrix = vtk.vtkMatrix4x4()
        transform.GetMatrixTransformToWorld(matrix)
        return tuple(matrix.GetElement(row, 3) for row in range(3))

    def _observeReadout(self):
        text = self.node(READOUT, "vtkMRMLTextNode")
        if text is None or text is self._text:
            return
        self.removeObservers(self._onReadout)
        self._text = text
        self.addObserver(text, slicer.vtkMRMLTextNode.TextModifiedEvent, self._onReadout)
        self._onReadout()

    def _onReadout(self, caller=None, event=None):
        try:
            self.values = readout(self._text.GetText() or "")
            if "time_s" in self.values:  # else nothing of an insertion is known
                self.curve.add(self.values)
            self.error = ""
        except (KeyError, ValueError) as error:
            self.error = str(error)

    def _place(self):
        patient = self.node(TO_PATIENT, "vtkMRMLLinearTransformNode") if self.isInPatient() else None
        parent = patient.GetID() if patient is not None else None
        for name, kind, color, opacity in PLACED:
            node = self.node(name, kind)
            if node is None:
                continue
            if name == CT and parent is None:  # that of another cochlea
                if name in self._styled:
                    self._styled.remove(name)
                    slicer.util.setSliceViewerLayers(background=None)
                continue
            if node.GetTransformNodeID() != parent:
                node.SetAndObserveTransformNodeID(parent)
            if name in self._styled:
                continue
            self._styled.add(name)
            display = node.GetDisplayNode()
            if color is not None and display is not None:
                display.SetColor(*color)
                display.SetOpacity(opacity)
            elif name == "PerilymphContacts" and display is not None:
                display.SetUseGlyphScale(False)
                display.SetGlyphSize(0.5)  # [mm]
                display.SetTextScale(1.5)
            elif name == CT:
                slicer.util.setSliceViewerLayers(background=node, fit=True)

    def _restrict(self):
        """Once everything that Slicer shows has come, the connector skips the rest: SENSOR, which it does not know and would
        report as an error at each message."""
        awaited = [(kind, name) for name, kind, _, _ in PLACED]
        awaited += [("vtkMRMLTextNode", READOUT)] + [("vtkMRMLLinearTransformNode", name) for name in (FORCE, TO_PATIENT)]
        if self._isRestricted or self.connector is None or any(self.node(name, kind) is None for kind, name in awaited):
            return
        self._isRestricted = True
        self.connector.SetRestrictDeviceName(1)

    def _plot(self):
        points = self.curve.points
        if not points:
            return
        if self._table is None:
            self._makeChart()
        depth, force = self._columns
        if len(points) < self._shown:  # another insertion, or a curve that was thinned out
            self._shown = 0
            depth.Reset()
            force.Reset()
        for place, newtons in points[self._shown:]:
            depth.InsertNextValue(place)
            force.InsertNextValue(1e3 * newtons)
        if len(points) != self._shown:
            self._shown = len(points)
            self._table.GetTable().Modified()
            self._table.Modified()

    def _makeChart(self):
        self._table = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLTableNode", "Insertion force")
        self._columns = []
        for name in ("Insertion depth (mm)", "Insertion force (mN)"):
            column = vtk.vtkDoubleArray()
            column.SetName(name)
            self._table.AddColumn(column)
            self._columns.append(self._table.GetTable().GetColumnByName(name))
        series = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLPlotSeriesNode", "Insertion force")
        series.SetAndObserveTableNodeID(self._table.GetID())
        series.SetPlotType(slicer.vtkMRMLPlotSeriesNode.PlotTypeScatter)
        series.SetMarkerStyle(slicer.vtkMRMLPlotSeriesNode.MarkerStyleNone)
        series.SetXColumnName("Insertion depth (mm)")
        series.SetYColumnName("Insertion force (mN)")
        series.SetColor(0.90, 0.45, 0.10)
        chart = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLPlotChartNode", "Insertion force")
        chart.AddAndObservePlotSeriesNodeID(series.GetID())
        chart.SetXAxisTitle("Insertion depth (mm)")
        chart.SetYAxisTitle("Insertion force (mN)")
        chart.SetLegendVisibility(False)
        slicer.modules.plots.logic().ShowChartInLayout(chart)


class PerilymphInsertionWidget(ScriptedLoadableModuleWidget):
    """Address, connection, and the force as numbers."""

    def setup(self):
        ScriptedLoadableModuleWidget.setup(self)
        self.logic = PerilymphInsertionLogic()
        section = ctk.ctkCollapsibleButton()
        section.text = "Perilymph"
        self.layout.addWidget(section)
        form = qt.QFormLayout(section)
        self.host = qt.QLineEdit("localhost")
        form.addRow("Computer:", self.host)
        self.port = qt.QSpinBox()
        self.port.setRange(1024, 65535)
        self.port.setValue(18944)
        form.addRow("Port:", self.port)
        self.button = qt.QPushButton("Connect")
        self.button.checkable = True
        self.button.toggled.connect(self.onConnect)
        form.addRow(self.button)
        self.follow = qt.QCheckBox("Slices follow the tip")
        form.addRow(self.follow)
        self.state = qt.QLabel()
        self.state.wordWrap = True
        form.addRow("State:", self.state)
        self.force = qt.QLabel()
        form.addRow("Insertion force:", self.force)
        self.depth = qt.QLabel()
        form.addRow("Insertion depth:", self.depth)
        self.layout.addStretch(1)
        self.timer = qt.QTimer()
        self.timer.setInterval(REFRESH_MS)
        self.timer.timeout.connect(self.onTimer)
        self.onTimer()

    def cleanup(self):
        self.timer.stop()
        self.logic.close()

    def onConnect(self, isOn):
        self.button.text = "Disconnect" if isOn else "Connect"
        if not isOn:
            self.timer.stop()
            self.logic.disconnect()
            self.onTimer()
            return
        try:
            self.logic.connect(self.host.text.strip(), self.port.value)
        except RuntimeError as error:
            self.button.checked = False
            slicer.util.errorDisplay(str(error))
            return
        self.timer.start()

    def onTimer(self):
        self.logic.refresh()
        self.state.text = self.logic.error or self.stateText()
        values = self.logic.values
        if "time_s" in values:
            self.force.text = f"{1e3 * values['force_axial_N']:.0f} mN, peak {1e3 * self.logic.curve.peak_N:.0f} mN"
            self.depth.text = f"{values['depth_mm']:.1f} mm, tip at {values['tip_angle_deg']:.0f} degrees"
        tip = self.logic.tip() if self.follow.checked else None
        if tip:
            slicer.modules.markups.logic().JumpSlicesToLocation(*tip, True)

    def stateText(self):
        if not self.button.checked:
            return "Not connected"
        if not self.logic.isConnected():
            return "Waiting for Perilymph: turn its stream on in its settings."
        if not self.logic.isInPatient():
            return "Connected. The CT of this cochlea is not open in Perilymph: the array is in the frame of the cochlea."
        return "Connected, in the coordinates of the patient's CT"
