#include "ui/workspace/actions.h"

#include <QActionGroup>
#include <QKeySequence>
#include <QMenu>
#include <QWidget>
#include <algorithm>

#include "model/base/assert.h"
#include "ui/workspace/key_presets.h"

namespace ui {

namespace {

using enum ActionId;

bool isChoice(MenuId menu) {
    constexpr MenuId kChoices[] = {MenuId::Arrangement, MenuId::Uses, MenuId::Theme, MenuId::Backend, MenuId::Keys};
    return std::ranges::find(kChoices, menu) != std::end(kChoices);
}

}  // namespace

// A row a line: the table is read by columns.
// clang-format off
const ActionSpec ActionSet::kSpecs[kActionCount] = {
    {OpenFile, MenuId::File, QT_TR_NOOP("&Open…"), "Ctrl+O", QT_TR_NOOP("Open a board of any known format")},
    {OpenFolder, MenuId::File, QT_TR_NOOP("Open &folder…"), "Ctrl+Shift+O", QT_TR_NOOP("Open a board that is a folder of files")},
    {Reload, MenuId::File, QT_TR_NOOP("&Reload"), "F5 Ctrl+R", QT_TR_NOOP("Read the board again from disk"), kNeedsBoard},
    {AssignLayers, MenuId::File, QT_TR_NOOP("&Assign layers…"), "Ctrl+Alt+A", QT_TR_NOOP("Say what the files of a Gerber job draw: layer, side, order, plating"), kNeedsBoard},
    {CancelLoading, MenuId::File, QT_TR_NOOP("S&top work"), "Ctrl+.", QT_TR_NOOP("Stop what is being done, reading a board first; the board on the screen stays")},
    {SaveSession, MenuId::File, QT_TR_NOOP("Save sessio&n"), "Ctrl+S", QT_TR_NOOP("Save cameras, layers and unit in the session file beside the board; they are restored when it is opened"), kNewGroup | kNeedsBoard},
    {ExportBoard, MenuId::File, QT_TR_NOOP("E&xport…"), "Ctrl+E", QT_TR_NOOP("Export the board, or a part of it, as a file for other programs"), kNewGroup | kNeedsBoard, QT_TR_NOOP("print plot drawings PDF STEP GLB STL DXF SVG mechanical")},
    {PrintBoard, MenuId::File, QT_TR_NOOP("Pr&int to PDF…"), "Ctrl+P", QT_TR_NOOP("Export layers as pages to scale, which any viewer of PDF prints"), kNeedsBoard, QT_TR_NOOP("print plot paper")},
    {SavePicture, MenuId::File, QT_TR_NOOP("&Save picture…"), "Ctrl+Shift+S", QT_TR_NOOP("Save the view as a PNG file"), kNeedsBoard, QT_TR_NOOP("screenshot image")},
    {SaveLargePicture, MenuId::File, QT_TR_NOOP("Save picture of any si&ze…"), "Ctrl+Alt+S", QT_TR_NOOP("Save the view as a PNG file of any number of pixels"), kNeedsBoard},
    {CopyPicture, MenuId::File, QT_TR_NOOP("Copy &picture"), "Ctrl+Shift+C", QT_TR_NOOP("Copy the view to the clipboard"), kNeedsBoard, QT_TR_NOOP("screenshot image")},
    {Quit, MenuId::File, QT_TR_NOOP("&Quit"), "Ctrl+Q", QT_TR_NOOP("Close the workbench"), kNewGroup},
    {Undo, MenuId::Edit, QT_TR_NOOP("&Undo"), "Ctrl+Z", QT_TR_NOOP("Undo the last change")},
    {Redo, MenuId::Edit, QT_TR_NOOP("&Redo"), "Ctrl+Shift+Z Ctrl+Y", QT_TR_NOOP("Redo the change that was undone")},
    {Find, MenuId::Edit, QT_TR_NOOP("&Find…"), "Ctrl+F", QT_TR_NOOP("Find a net, component, pin, attribute, layer, location or command"), kNewGroup},
    {Commands, MenuId::Edit, QT_TR_NOOP("&Commands…"), "Ctrl+Shift+P", QT_TR_NOOP("Find a command by its name, its menu or what it does, and run it")},
    {Fit, MenuId::View, QT_TR_NOOP("&Fit"), "F Home", QT_TR_NOOP("Fit the whole board into the view, direction unchanged"), kNeedsBoard},
    {ViewTop, MenuId::View, QT_TR_NOOP("&Top"), "T", QT_TR_NOOP("View from the top side"), kNeedsBoard},
    {ViewBottom, MenuId::View, QT_TR_NOOP("&Bottom"), "B", QT_TR_NOOP("View from the bottom side"), kNeedsBoard},
    {ViewIso, MenuId::View, QT_TR_NOOP("&Isometric"), "I", QT_TR_NOOP("View from a corner"), kNeedsBoard | kInSolid},
    {Flip, MenuId::View, QT_TR_NOOP("Fli&p board"), "Space", QT_TR_NOOP("Look at the other side of the board"), kNeedsBoard, QT_TR_NOOP("mirror")},
    {ZoomIn, MenuId::View, QT_TR_NOOP("&Zoom in"), "+ =", QT_TR_NOOP("Zoom in at the centre"), kNewGroup | kNeedsBoard},
    {ZoomOut, MenuId::View, QT_TR_NOOP("Zoom o&ut"), "-", QT_TR_NOOP("Zoom out at the centre"), kNeedsBoard},
    {ViewBack, MenuId::View, QT_TR_NOOP("B&ack"), "Alt+Left", QT_TR_NOOP("Previous position of the camera"), kNeedsBoard},
    {ViewForward, MenuId::View, QT_TR_NOOP("Forwar&d"), "Alt+Right", QT_TR_NOOP("Next position of the camera, after Back"), kNeedsBoard},
    {SaveView, MenuId::View, QT_TR_NOOP("Save t&his view"), "Ctrl+B", QT_TR_NOOP("Save both cameras, the visible layers and what is selected or highlighted under a name, in the session file beside the board"), kNeedsBoard},
    {Orthographic, MenuId::View, QT_TR_NOOP("&Orthographic"), "O", QT_TR_NOOP("Parallel projection instead of perspective"), kCheckable | kInSolid},
    {Explode, MenuId::View, QT_TR_NOOP("&Explode"), "E", QT_TR_NOOP("Spread the layers apart"), kCheckable | kInSolid},
    {ShowViewCube, MenuId::View, QT_TR_NOOP("Vie&w cube"), "K", QT_TR_NOOP("Show a cube in 3D whose sides set the direction of view"), kCheckable | kInSolid},
    {ShowFrameDisplay, MenuId::View, QT_TR_NOOP("Frame di&splay"), "Ctrl+K,F", QT_TR_NOOP("Show frame time, back end and what is drawn, in 3D"), kCheckable | kInSolid},
    {ExaggerateCopperHeight, MenuId::Solid, QT_TR_NOOP("&Copper scale ×10"), "C", QT_TR_NOOP("Draw copper at ten times its thickness, in 3D"), kCheckable | kInSolid},
    {ExaggerateDielectricHeight, MenuId::Solid, QT_TR_NOOP("&Dielectric scale ×5"), "V", QT_TR_NOOP("Draw all layers but copper at five times their thickness, in 3D"), kCheckable | kInSolid},
    {ShowMilledAway, MenuId::Solid, QT_TR_NOOP("Show what is &milled away"), "Ctrl+K,E", QT_TR_NOOP("Show also what the fabricator mills away beyond the board outline: without this it is faint in 2D and not there in 3D"), kCheckable},
    {SectionPlane, MenuId::Solid, QT_TR_NOOP("&Section plane"), "X", QT_TR_NOOP("Cut the board through the pointer, or through its middle, in 3D; again to remove the plane"), kCheckable | kNewGroup | kInSolid},
    {RotateSectionPlane, MenuId::Solid, QT_TR_NOOP("&Rotate plane"), "Shift+X", QT_TR_NOOP("Rotate the section plane by 45 degrees")},
    {MoveSectionPlaneOn, MenuId::Solid, QT_TR_NOOP("Move plane &forward"), ".", QT_TR_NOOP("Move the section plane, so that less of the board is left")},
    {MoveSectionPlaneBack, MenuId::Solid, QT_TR_NOOP("Move plane &back"), ",", QT_TR_NOOP("Move the section plane, so that more of the board is left")},
    {ShowFlat, MenuId::Arrangement, QT_TR_NOOP("&2D only"), "2", QT_TR_NOOP("Show the 2D view only"), kCheckable},
    {ShowSolid, MenuId::Arrangement, QT_TR_NOOP("&3D only"), "3", QT_TR_NOOP("Show the 3D view only"), kCheckable},
    {ShowSideBySide, MenuId::Arrangement, QT_TR_NOOP("&Side by side"), "4", QT_TR_NOOP("Show 2D to the left of 3D"), kCheckable},
    {ShowStacked, MenuId::Arrangement, QT_TR_NOOP("One &above the other"), "5", QT_TR_NOOP("Show 2D above 3D"), kCheckable},
    {UseGeneral, MenuId::Uses, QT_TR_NOOP("&General"), "Ctrl+F9", QT_TR_NOOP("Arrange panels for a look around: layers, element"), kCheckable},
    {UseStackup, MenuId::Uses, QT_TR_NOOP("&Stackup"), "Ctrl+F10", QT_TR_NOOP("Arrange panels for work on the stackup: stackup, layers"), kCheckable},
    {UseNets, MenuId::Uses, QT_TR_NOOP("&Nets"), "Ctrl+F11", QT_TR_NOOP("Arrange panels for work on nets: nets, layers, element, pins"), kCheckable},
    {UseClearance, MenuId::Uses, QT_TR_NOOP("&Clearance"), "Ctrl+F12", QT_TR_NOOP("Arrange panels for clearances: clearances, measurements, layers"), kCheckable},
    {RestorePanels, MenuId::Uses, QT_TR_NOOP("&Restore default"), "Ctrl+Shift+F9", QT_TR_NOOP("Arrange the panels of this use as they were at first"), kNewGroup},
    {ShowLayersDock, MenuId::Panels, QT_TR_NOOP("&Layers"), "Ctrl+1", QT_TR_NOOP("Show or hide the layers panel"), kCheckable},
    {ShowNetsDock, MenuId::Panels, QT_TR_NOOP("&Nets"), "Ctrl+5", QT_TR_NOOP("Show or hide the nets"), kCheckable},
    {ShowElementDock, MenuId::Panels, QT_TR_NOOP("Ele&ment"), "Ctrl+4", QT_TR_NOOP("Show or hide the properties of the selected element"), kCheckable},
    {ShowNetCheckDock, MenuId::Panels, QT_TR_NOOP("Netlist c&heck"), "Ctrl+7", QT_TR_NOOP("Show or hide opens, shorts and floating copper"), kCheckable, QT_TR_NOOP("unconnected unrouted")},
    {ShowStackupDock, MenuId::Panels, QT_TR_NOOP("Stac&kup"), "Ctrl+6", QT_TR_NOOP("Show or hide the stackup and its thicknesses"), kCheckable},
    {ShowStatisticsDock, MenuId::Panels, QT_TR_NOOP("&Statistics"), "Ctrl+2", QT_TR_NOOP("Show or hide the element statistics and the drill table"), kCheckable, QT_TR_NOOP("drill drills hole holes boardsize dimensions")},
    {ShowSavedViewsDock, MenuId::Panels, QT_TR_NOOP("Saved vie&ws"), "Ctrl+8", QT_TR_NOOP("Show or hide the saved views"), kCheckable},
    {ShowClearanceDock, MenuId::Panels, QT_TR_NOOP("&Clearances"), "Ctrl+9", QT_TR_NOOP("Show or hide smallest clearances, rules, lens and map"), kCheckable},
    {ShowMeasurementsDock, MenuId::Panels, QT_TR_NOOP("Meas&urements"), "Ctrl+0", QT_TR_NOOP("Show or hide the measurements"), kCheckable},
    {ShowSectionDock, MenuId::Panels, QT_TR_NOOP("Cr&oss-section"), "Ctrl+Alt+0", QT_TR_NOOP("Show or hide the cross-section"), kCheckable},
    {ShowPartsDock, MenuId::Panels, QT_TR_NOOP("&Parts"), "Ctrl+Alt+1", QT_TR_NOOP("Show or hide the components, as the bill of materials (BOM) too"), kCheckable, QT_TR_NOOP("placement BOM pick-and-place centroid testpoint testpoints")},
    {ShowPinsDock, MenuId::Panels, QT_TR_NOOP("P&ins"), "Ctrl+Alt+2", QT_TR_NOOP("Show or hide the pins of the selected components or highlighted nets"), kCheckable},
    {ShowComparisonDock, MenuId::Panels, QT_TR_NOOP("Comp&arison"), "Ctrl+Alt+3", QT_TR_NOOP("Show or hide how the board differs from another one"), kCheckable, QT_TR_NOOP("diff revision XOR ECO")},
    {ShowMessagesDock, MenuId::Panels, QT_TR_NOOP("Messa&ges"), "Ctrl+3", QT_TR_NOOP("Show or hide what was skipped, repaired or assumed"), kCheckable},
    {ShowToolBar, MenuId::Panels, QT_TR_NOOP("Toolba&r"), "Ctrl+K,B", QT_TR_NOOP("Show or hide the toolbar"), kCheckable},
    {NextPanel, MenuId::Panels, QT_TR_NOOP("Ne&xt panel"), "F6", QT_TR_NOOP("Move the keyboard to the next view or panel"), kNewGroup},
    {PreviousPanel, MenuId::Panels, QT_TR_NOOP("Pre&vious panel"), "Shift+F6", QT_TR_NOOP("Move the keyboard to the previous view or panel")},
    {ThemeSystem, MenuId::Theme, QT_TR_NOOP("&System"), "Ctrl+K,S", QT_TR_NOOP("Colours of the desktop"), kCheckable},
    {ThemeDark, MenuId::Theme, QT_TR_NOOP("&Dark"), "Ctrl+K,D", QT_TR_NOOP("Light text on dark panels"), kCheckable},
    {ThemeLight, MenuId::Theme, QT_TR_NOOP("&Light"), "Ctrl+K,L", QT_TR_NOOP("Dark text on light panels"), kCheckable},
    {BackendAuto, MenuId::Backend, QT_TR_NOOP("&Automatic"), "Ctrl+K,A", QT_TR_NOOP("The best back end for this device"), kCheckable},
    {BackendMesh, MenuId::Backend, QT_TR_NOOP("&Mesh shaders"), "Ctrl+K,M", QT_TR_NOOP("Task and mesh shaders; the device must have them"), kCheckable},
    {BackendPull, MenuId::Backend, QT_TR_NOOP("&Vertex pulling"), "Ctrl+K,P", QT_TR_NOOP("Compute culling and indirect draws; works on every device"), kCheckable},
    {BackendImpostor, MenuId::Backend, QT_TR_NOOP("&Exact outlines"), "Ctrl+K,O", QT_TR_NOOP("Impostors: boxes whose pixels are cut by the true outlines; works on every device"), kCheckable},
    {BackendRaster, MenuId::Backend, QT_TR_NOOP("&Compute rasterising"), "Ctrl+K,R", QT_TR_NOOP("Compute shaders draw what is small, unsmoothed; the device must have 64-bit atomics"), kCheckable},
    {KeysCopperscope, MenuId::Keys, QT_TR_NOOP("&Copperscope"), "Ctrl+K,F1", QT_TR_NOOP("The keys of Copperscope itself"), kCheckable},
    {KeysKiCad, MenuId::Keys, QT_TR_NOOP("&KiCad"), "Ctrl+K,F2", QT_TR_NOOP("Keys of KiCad's board editor, where it has them"), kCheckable},
    {KeysAltium, MenuId::Keys, QT_TR_NOOP("&Altium"), "Ctrl+K,F3", QT_TR_NOOP("Keys of Altium Designer, where it has them"), kCheckable},
    {KeysAllegro, MenuId::Keys, QT_TR_NOOP("Alle&gro"), "Ctrl+K,F4", QT_TR_NOOP("Keys of Allegro, where it has them"), kCheckable},
    {KeysKLayout, MenuId::Keys, QT_TR_NOOP("K&Layout"), "Ctrl+K,F5", QT_TR_NOOP("Keys of KLayout, where it has them"), kCheckable},
    {ShowDefaultLayers, MenuId::Layers, QT_TR_NOOP("Default &set"), "Ctrl+K,0", QT_TR_NOOP("Show the layers that are visible when a board is opened"), kNeedsBoard},
    {ShowAllLayers, MenuId::Layers, QT_TR_NOOP("Show &all"), "Ctrl+Shift+A", QT_TR_NOOP("Show every layer"), kNeedsBoard},
    {HideAllLayers, MenuId::Layers, QT_TR_NOOP("&Hide all"), "Ctrl+Shift+H", QT_TR_NOOP("Hide every layer"), kNeedsBoard},
    {ShowCopperOnly, MenuId::Layers, QT_TR_NOOP("&Copper only"), "Ctrl+Shift+K", QT_TR_NOOP("Show the copper layers only"), kNeedsBoard},
    {ShowTopLayers, MenuId::Layers, QT_TR_NOOP("To&p"), "Ctrl+K,5", QT_TR_NOOP("Show top copper, what is seen on it, holes and the board"), kNeedsBoard},
    {ShowBottomLayers, MenuId::Layers, QT_TR_NOOP("Botto&m"), "Ctrl+K,6", QT_TR_NOOP("Show bottom copper, what is seen on it, holes and the board"), kNeedsBoard},
    {ShowInnerLayers, MenuId::Layers, QT_TR_NOOP("&Inner"), "Ctrl+K,7", QT_TR_NOOP("Show inner copper and holes"), kNeedsBoard},
    {ShowAssemblyLayers, MenuId::Layers, QT_TR_NOOP("Assembl&y"), "Ctrl+K,8", QT_TR_NOOP("Show components, silkscreen and assembly drawings"), kNeedsBoard},
    {ShowFabricationLayers, MenuId::Layers, QT_TR_NOOP("&Fabrication"), "Ctrl+K,9", QT_TR_NOOP("Show what a fabricator makes: copper, solder mask, silkscreen and holes"), kNeedsBoard},
    {ShowComponents, MenuId::Layers, QT_TR_NOOP("Compo&nents"), "Shift+C Ctrl+K,K", QT_TR_NOOP("Draw the bodies of the components on both sides"), kCheckable | kNeedsBoard},
    {SaveLayerSet, MenuId::Layers, QT_TR_NOOP("Save &layer set…"), "Ctrl+K,W", QT_TR_NOOP("Save the visible layers under a name, in the session file beside the board"), kNeedsBoard},
    {SoloLayer, MenuId::Layers, QT_TR_NOOP("&Only this layer"), "H", QT_TR_NOOP("Show the current layer of the panel only; again to go back"), kNewGroup | kNeedsBoard},
    {Contrast, MenuId::Layers, QT_TR_NOOP("High con&trast"), "Shift+H", QT_TR_NOOP("Dim all layers but the current one of the panel, in 2D"), kCheckable | kNeedsBoard | kInFlat},
    {NextLayer, MenuId::Layers, QT_TR_NOOP("Layer &below"), "PgDown", QT_TR_NOOP("Make the next visible layer the current one"), kNeedsBoard},
    {PreviousLayer, MenuId::Layers, QT_TR_NOOP("Layer abo&ve"), "PgUp", QT_TR_NOOP("Make the visible layer before the current one"), kNeedsBoard},
    {TopCopper, MenuId::Layers, QT_TR_NOOP("Top coppe&r"), "Ctrl+PgUp Ctrl+K,PgUp", QT_TR_NOOP("Make top copper the current layer"), kNeedsBoard},
    {BottomCopper, MenuId::Layers, QT_TR_NOOP("Bottom copp&er"), "Ctrl+PgDown Ctrl+K,PgDown", QT_TR_NOOP("Make bottom copper the current layer"), kNeedsBoard},
    {NoCurrentLayer, MenuId::Layers, QT_TR_NOOP("Dra&w none over the others"), "Ctrl+K,N", QT_TR_NOOP("Let no layer be the current one, which 2D draws over the others"), kNeedsBoard},
    {RestoreLayers, MenuId::Layers, QT_TR_NOOP("&Default colours"), "Ctrl+Shift+D", QT_TR_NOOP("Reset colours, opacities and visibility"), kNeedsBoard},
    {SafeColours, MenuId::Layers, QT_TR_NOOP("Colo&ur-blind safe"), "Ctrl+K,C", QT_TR_NOOP("Palette that does not rely on red against green"), kCheckable},
    {ColourNet, MenuId::Nets, QT_TR_NOOP("&Colour net"), "U", QT_TR_NOOP("Give the nets of the selection, or with none the one under the pointer, a colour that stays; again to remove it"), kNeedsBoard},
    {ChooseNetColour, MenuId::Nets, QT_TR_NOOP("C&hoose colour…"), "Shift+U", QT_TR_NOOP("Choose the colour of the nets of the selection, or with none of the one under the pointer"), kNeedsBoard},
    {HideNet, MenuId::Nets, QT_TR_NOOP("H&ide net"), "Shift+N", QT_TR_NOOP("Hide the nets of the selection, or with none the one under the pointer; they cannot be clicked"), kNeedsBoard},
    {IsolateNet, MenuId::Nets, QT_TR_NOOP("Isol&ate net"), "Shift+I", QT_TR_NOOP("Hide all nets but those of the selection, or with none but the one under the pointer; again to show all"), kNeedsBoard},
    {ShowAllNets, MenuId::Nets, QT_TR_NOOP("&Show all nets"), "Ctrl+Alt+N", QT_TR_NOOP("Show all hidden nets"), kNewGroup | kNeedsBoard},
    {ClearNetColours, MenuId::Nets, QT_TR_NOOP("C&lear colours"), "Ctrl+Alt+U", QT_TR_NOOP("Show all nets in the colours of their layers"), kNeedsBoard},
    {CheckNets, MenuId::Board, QT_TR_NOOP("Netlist &check"), "Ctrl+Shift+N", QT_TR_NOOP("Compare the nets with the copper: opens, shorts and floating copper"), kNeedsBoard, QT_TR_NOOP("compare opens shorts unconnected unrouted")},
    {InferNets, MenuId::Board, QT_TR_NOOP("Infer &nets from copper"), "Ctrl+Shift+I", QT_TR_NOOP("Read the board again with nets found by following the copper, instead of the job's"), kCheckable | kNeedsBoard},
    {CompareFile, MenuId::Board, QT_TR_NOOP("Compare &with a board…"), "Ctrl+Alt+C", QT_TR_NOOP("Compare with another board, like another revision or the files made of this one, and list what differs"), kNewGroup | kNeedsBoard, QT_TR_NOOP("diff revision XOR ECO")},
    {CompareFolder, MenuId::Board, QT_TR_NOOP("Compare wit&h a folder…"), "Ctrl+Alt+Shift+C", QT_TR_NOOP("The same with an unpacked job, or a folder of Gerber files"), kNeedsBoard, QT_TR_NOOP("diff revision XOR ECO")},
    {ExaggerateCopper, MenuId::Board, QT_TR_NOOP("E&xaggerate copper"), "Ctrl+Shift+X", QT_TR_NOOP("Draw copper as thick as dielectric in the stackup; off: to scale"), kCheckable | kNewGroup},
    {ExportStackup, MenuId::Board, QT_TR_NOOP("Export &stackup…"), "Ctrl+Shift+E", QT_TR_NOOP("Export the stackup as a drawing (SVG, PDF) or a table (CSV)"), kNeedsBoard, QT_TR_NOOP("print")},
    {SearchClearances, MenuId::Board, QT_TR_NOOP("&Find clearances"), "Ctrl+Shift+G", QT_TR_NOOP("Find the smallest clearances, or what breaks the rules, as the Clearances panel says"), kNewGroup | kNeedsBoard},
    {NextClearance, MenuId::Board, QT_TR_NOOP("Next clea&rance"), "F8", QT_TR_NOOP("Show the next row of the Clearances panel in both views"), kNeedsBoard},
    {PreviousClearance, MenuId::Board, QT_TR_NOOP("&Previous clearance"), "Shift+F8", QT_TR_NOOP("Show the previous row of the Clearances panel in both views"), kNeedsBoard},
    {CheckRules, MenuId::Board, QT_TR_NOOP("Chec&k rules"), "Ctrl+Shift+R", QT_TR_NOOP("Check the whole board by the clearance rules and net classes, in the Clearances panel"), kNeedsBoard, QT_TR_NOOP("DRC annular ring")},
    {EditRules, MenuId::Board, QT_TR_NOOP("Edit r&ules…"), "Ctrl+Alt+R", QT_TR_NOOP("Edit clearance rules and net classes"), kNeedsBoard, QT_TR_NOOP("DRC annular ring")},
    {ExportClearances, MenuId::Board, QT_TR_NOOP("&Export clearances…"), "Ctrl+Alt+G", QT_TR_NOOP("Export clearances as text, table or JSON, broken rules also as JUnit, SARIF or a page with drawings"), kNeedsBoard},
    {Lens, MenuId::Board, QT_TR_NOOP("Clearance &lens"), "L", QT_TR_NOOP("Highlight copper of other nets near what is selected or highlighted"), kCheckable | kNeedsBoard},
    {ClearanceMap, MenuId::Board, QT_TR_NOOP("Clearance &map"), "Shift+G", QT_TR_NOOP("Colour a copper layer by the distance to what is selected, or by the spacing between nets"), kCheckable | kNeedsBoard},
    {DrawSection, MenuId::Board, QT_TR_NOOP("&Draw section"), "Shift+S", QT_TR_NOOP("Drag a line over the 2D view, or click its corners; corners can be moved afterwards"), kCheckable | kNewGroup | kNeedsBoard | kInFlat},
    {SectionAlongNet, MenuId::Board, QT_TR_NOOP("Section &along net"), "Ctrl+Alt+L", QT_TR_NOOP("Cut along the longest track chain of the highlighted net, unrolled"), kNeedsBoard},
    {OpenAlongSection, MenuId::Board, QT_TR_NOOP("Sh&ow section in 3D"), "Alt+X", QT_TR_NOOP("Move the section plane of the 3D view to the straight line of the section"), kNeedsBoard},
    {SaveSection, MenuId::Board, QT_TR_NOOP("Sa&ve section"), "Ctrl+Alt+B", QT_TR_NOOP("Save the line of the section under a name, in the session file beside the board"), kNeedsBoard},
    {ExportSection, MenuId::Board, QT_TR_NOOP("Expor&t section…"), "Ctrl+Alt+E", QT_TR_NOOP("Export the section as a drawing (SVG, PDF)"), kNeedsBoard, QT_TR_NOOP("print")},
    {MeasurePoints, MenuId::Measure, QT_TR_NOOP("&Point to point"), "M", QT_TR_NOOP("Click two points in 2D or 3D to measure from one to the other; again to stop"), kCheckable | kNeedsBoard, QT_TR_NOOP("measure distance ruler")},
    {MeasureObjects, MenuId::Measure, QT_TR_NOOP("&Clearance (edge to edge)"), "Shift+M", QT_TR_NOOP("Click two elements to measure the clearance between them, through the stackup too; again to stop"), kCheckable | kNeedsBoard, QT_TR_NOOP("measure distance")},
    {MeasureAngle, MenuId::Measure, QT_TR_NOOP("&Angle of three points"), "A", QT_TR_NOOP("Click the corner and a point on each arm; again to stop"), kCheckable | kNeedsBoard, QT_TR_NOOP("measure")},
    {MeasureLines, MenuId::Measure, QT_TR_NOOP("Angle of two &lines"), "Shift+A", QT_TR_NOOP("Click two straight tracks or sides to measure the angle between them; again to stop"), kCheckable | kNeedsBoard, QT_TR_NOOP("measure")},
    {MeasureRadius, MenuId::Measure, QT_TR_NOOP("&Radius"), "Shift+R", QT_TR_NOOP("Click an arc, a round pad or a hole for its radius and diameter; again to stop"), kCheckable | kNeedsBoard, QT_TR_NOOP("measure diameter")},
    {MeasureLength, MenuId::Measure, QT_TR_NOOP("&Net path length"), "J Ctrl+J", QT_TR_NOOP("Click two locations on a net to measure along its copper; again to stop"), kCheckable | kNeedsBoard, QT_TR_NOOP("measure trace")},
    {MeasureSpacing, MenuId::Measure, QT_TR_NOOP("&Spacing at cursor"), "R", QT_TR_NOOP("Measure from the copper nearest to the pointer to the next copper on its layer"), kNeedsBoard, QT_TR_NOOP("measure distance")},
    {ShowMeasurements, MenuId::Measure, QT_TR_NOOP("Sho&w measurements"), "Ctrl+K,H", QT_TR_NOOP("Draw the measurements that were made, in both views"), kCheckable | kNewGroup | kNeedsBoard},
    {DeleteMeasurements, MenuId::Measure, QT_TR_NOOP("&Delete all measurements"), "Ctrl+K,X", QT_TR_NOOP("Delete all measurements of this board; Undo brings them back"), kNeedsBoard},
    {ExportMeasurements, MenuId::Measure, QT_TR_NOOP("E&xport measurements…"), "Ctrl+Alt+M", QT_TR_NOOP("Export all measurements as a table (CSV)"), kNeedsBoard},
    {ClearSelection, MenuId::Select, QT_TR_NOOP("&Clear"), "Esc", QT_TR_NOOP("Step back, one thing at a time: stop work, measuring or drawing, remove a location mark, show all layers again, close an error message, clear the selected elements, the highlighted nets"), kNeedsBoard},
    {ShowSelection, MenuId::Select, QT_TR_NOOP("&Show in both views"), "Z", QT_TR_NOOP("Zoom both views to the selected elements, or else to the highlighted nets"), kNeedsBoard},
    {SelectComponent, MenuId::Select, QT_TR_NOOP("Select com&ponent"), "P", QT_TR_NOOP("Select all pads, holes and the body of the component under the pointer, or of the selected element"), kNeedsBoard},
    {SelectPin, MenuId::Select, QT_TR_NOOP("Select p&in"), "Shift+P", QT_TR_NOOP("Select all pads and the hole of the pin under the pointer, or of the selected element"), kNeedsBoard},
    {SaveSelection, MenuId::Select, QT_TR_NOOP("Sa&ve selection"), "Ctrl+Shift+B", QT_TR_NOOP("Save what is selected and highlighted under a name, in the session file beside the board"), kNeedsBoard},
    {HighlightNet, MenuId::Select, QT_TR_NOOP("Highlight &net"), "N", QT_TR_NOOP("Highlight the net of the element under the pointer, or the nets of the selection, and no others; again to stop"), kNewGroup | kNeedsBoard},
    {AddNet, MenuId::Select, QT_TR_NOOP("Add net to hi&ghlight"), "Ctrl+N", QT_TR_NOOP("Highlight the net of the element under the pointer, or the nets of the selection, beside the others; again to stop"), kNeedsBoard},
    {DimOthers, MenuId::Select, QT_TR_NOOP("&Dim others"), "D", QT_TR_NOOP("Fade everything that is not selected or highlighted"), kCheckable},
    {FollowInSolid, MenuId::Select, QT_TR_NOOP("Follow in &3D"), "Ctrl+K,3", QT_TR_NOOP("Move the 3D view to what is clicked in 2D"), kCheckable | kNewGroup},
    {FollowInFlat, MenuId::Select, QT_TR_NOOP("Follow in &2D"), "Ctrl+K,2", QT_TR_NOOP("Move the 2D view to what is clicked in 3D"), kCheckable},
    {FollowInTables, MenuId::Select, QT_TR_NOOP("Follow in &tables"), "Ctrl+K,T", QT_TR_NOOP("Scroll tables to the net of what is clicked in a view"), kCheckable},
    {FollowFromTables, MenuId::Select, QT_TR_NOOP("Follow t&ables in views"), "Ctrl+K,V", QT_TR_NOOP("Move both views to what is chosen in a table"), kCheckable},
    {NextUnit, MenuId::View, QT_TR_NOOP("Ne&xt unit"), "Q Ctrl+U", QT_TR_NOOP("Millimetres, mils, inches"), kNewGroup},
    {ShowGrid, MenuId::View, QT_TR_NOOP("&Grid and rulers"), "G", QT_TR_NOOP("Show a grid and rulers in 2D"), kCheckable | kInFlat},
    {ShowNames, MenuId::View, QT_TR_NOOP("Net na&mes"), "W", QT_TR_NOOP("Show the names of nets on the copper in 2D, where there is room"), kCheckable | kInFlat},
    {ShowOutlines, MenuId::View, QT_TR_NOOP("Out&lines only"), "S", QT_TR_NOOP("Draw outlines without fill, in 2D"), kCheckable | kInFlat},
    {ShowPinNames, MenuId::View, QT_TR_NOOP("Pi&n names"), "Shift+W", QT_TR_NOOP("Show the names of pins on their pads in 2D, where there is room"), kCheckable | kInFlat},
    {ShowGuide, MenuId::Help, QT_TR_NOOP("&Guide"), "F1", QT_TR_NOOP("How to open boards, follow nets, measure, check clearances, cut and export, with pictures")},
    {ShowKeys, MenuId::Help, QT_TR_NOOP("&Keys and mouse"), "?", QT_TR_NOOP("All keys and mouse gestures on one page")},
    {ResetSettings, MenuId::Help, QT_TR_NOOP("&Reset settings…"), "Ctrl+K,Delete", QT_TR_NOOP("Reset window, panels, theme, what the views show and recent boards"), kNewGroup},
    {About, MenuId::Help, QT_TR_NOOP("&About Copperscope"), "Shift+F1", QT_TR_NOOP("Version and licence"), kNewGroup},
};
// clang-format on

const char* const ActionSet::kMenuTitles[kMenuCount] = {
    QT_TR_NOOP("&File"),      QT_TR_NOOP("&Edit"),        QT_TR_NOOP("&View"),   QT_TR_NOOP("Se&ction plane and scale"),
    QT_TR_NOOP("2D and &3D"), QT_TR_NOOP("A&rrangement"), QT_TR_NOOP("Pa&nels"), QT_TR_NOOP("The&me"),
    QT_TR_NOOP("Bac&k end"),  QT_TR_NOOP("&Keys"),        QT_TR_NOOP("&Layers"), QT_TR_NOOP("&Nets"),
    QT_TR_NOOP("&Board"),     QT_TR_NOOP("&Measure"),     QT_TR_NOOP("&Select"), QT_TR_NOOP("&Help")};

QString menuTitle(MenuId menu) {
    return ActionSet::tr(ActionSet::kMenuTitles[static_cast<std::size_t>(menu)]);
}

QList<QKeySequence> keysFrom(const char* shortcuts) {
    QList<QKeySequence> keys;
    for (const QString& key : QString::fromUtf8(shortcuts).split(' ', Qt::SkipEmptyParts)) {
        keys += QKeySequence::fromString(key, QKeySequence::PortableText);
    }
    return keys;
}

ActionSet::ActionSet(QWidget& window) : QObject(&window), m_window(window) {
    std::array<QActionGroup*, kMenuCount> groups{};
    for (const ActionSpec& spec : kSpecs) {
        auto* action = new QAction(&window);
        apply(spec, *action);
        m_actions[static_cast<std::size_t>(spec.id)] = action;
        if (isChoice(spec.menu)) {
            QActionGroup*& group = groups[static_cast<std::size_t>(spec.menu)];
            group = group != nullptr ? group : new QActionGroup(&window);
            group->addAction(action);
        }
    }
}

void ActionSet::apply(const ActionSpec& spec, QAction& action) const {
    ASSERT(&spec == &kSpecs[static_cast<std::size_t>(spec.id)]);
    action.setText(tr(spec.text));
    action.setStatusTip(tr(spec.tip));
    action.setCheckable((spec.flags & kCheckable) != 0);
    applyKeys(spec, action);
    m_window.addAction(&action);
}

void ActionSet::applyKeys(const ActionSpec& spec, QAction& action) const {
    const QList<QKeySequence> keys = keysOf(spec, m_keys);
    action.setShortcuts(keys);
    action.setToolTip(tr("%1 (%2)").arg(tr(spec.tip), keysText(keys, tr(" or "))));  // "Zoom in (+ or =)"
}

void ActionSet::setKeys(KeyPreset keys) {
    m_keys = keys;
    for (const ActionSpec& spec : kSpecs) {
        applyKeys(spec, (*this)[spec.id]);
    }
}

void ActionSet::enable(bool hasBoard) const {
    for (const ActionSpec& spec : kSpecs) {
        if ((spec.flags & kNeedsBoard) != 0) {
            (*this)[spec.id].setEnabled(hasBoard);
        }
    }
}

void ActionSet::adopt(ActionId id, QAction& action) {
    QAction*& slot = m_actions[static_cast<std::size_t>(id)];
    delete slot;
    slot = &action;
    apply(kSpecs[static_cast<std::size_t>(id)], action);
}

void ActionSet::fill(QMenu& menu, MenuId id) const {
    for (const ActionSpec& spec : kSpecs) {
        if (spec.menu != id) {
            continue;
        }
        if ((spec.flags & kNewGroup) != 0) {
            menu.addSeparator();
        }
        menu.addAction(&(*this)[spec.id]);
    }
}

}  // namespace ui
