#include "ui/workspace/actions.h"

#include <QActionGroup>
#include <QKeySequence>
#include <QMenu>
#include <QWidget>

#include "model/base/assert.h"
#include "ui/workspace/key_presets.h"

namespace ui {

namespace {

using enum ActionId;

constexpr bool kCheckable = true;
constexpr bool kNewGroup = true;

constexpr ActionSpec kSpecs[] = {
    {OpenFile, MenuId::File, "&Open…", "Ctrl+O", "Open an ODB++ archive (.tgz, .zip) or a text board"},
    {OpenFolder, MenuId::File, "Open &folder…", "Ctrl+Shift+O", "Open an unpacked ODB++ job"},
    {Reload, MenuId::File, "&Reload", "F5 Ctrl+R", "Read the board again from disk"},
    {CancelLoading, MenuId::File, "&Cancel loading", "Ctrl+.", "Stop reading and keep the board on the screen"},
    {SaveSession, MenuId::File, "Save sessio&n", "Ctrl+S",
     "Keep cameras, layers and unit in the session file beside the board, and show them when it is opened again", false,
     kNewGroup},
    {SavePicture, MenuId::File, "&Save picture…", "Ctrl+Shift+S", "Write what the canvas shows to a PNG file", false,
     kNewGroup},
    {SaveLargePicture, MenuId::File, "Save picture of any si&ze…", "Ctrl+Alt+S",
     "Write what the canvas shows to a PNG file, with as many pixels as you like"},
    {CopyPicture, MenuId::File, "Copy &picture", "Ctrl+Shift+C", "Put what the canvas shows on the clipboard"},
    {Quit, MenuId::File, "&Quit", "Ctrl+Q", "Close the workbench", false, kNewGroup},

    {Undo, MenuId::Edit, "&Undo", "Ctrl+Z", "Take the last change of a thickness, a kept view or a measurement back"},
    {Redo, MenuId::Edit, "&Redo", "Ctrl+Shift+Z Ctrl+Y", "Make the change again that was taken back"},
    {Find, MenuId::Edit, "&Find…", "Ctrl+F", "Find a net, component, pin, layer, place or command", false, kNewGroup},
    {Commands, MenuId::Edit, "&Commands…", "Ctrl+Shift+P", "Find a command by its name and do it"},

    {Fit, MenuId::View, "&Fit", "F Home", "Show the whole board, direction unchanged"},
    {ViewTop, MenuId::View, "&Top", "T", "Look straight down on the top side"},
    {ViewBottom, MenuId::View, "&Bottom", "B", "Look straight up on the bottom side"},
    {ViewIso, MenuId::View, "&Isometric", "I", "Look from a corner"},
    {Flip, MenuId::View, "Turn o&ver", "Space", "Look at the other side of the board"},
    {ZoomIn, MenuId::View, "&Zoom in", "+ =", "Come closer", false, kNewGroup},
    {ZoomOut, MenuId::View, "Zoom o&ut", "-", "Step back from the board"},
    {ViewBack, MenuId::View, "B&ack", "Alt+Left", "Look where the view in use rested before"},
    {ViewForward, MenuId::View, "Forwar&d", "Alt+Right", "Look again where Back came from"},
    {SaveView, MenuId::View, "Keep t&his view", "Ctrl+B",
     "Keep both cameras and the visible layers under a name, in the session file beside the board"},
    {Orthographic, MenuId::View, "&Orthographic", "O", "Parallel projection instead of perspective", kCheckable},
    {Explode, MenuId::View, "&Explode", "E", "Spread the layers apart", kCheckable},
    {ShowViewCube, MenuId::View, "Vie&w cube", "K", "In 3D, show a cube whose sides can be clicked to look from there",
     kCheckable},
    {ShowFrameDisplay, MenuId::View, "Frame di&splay", "Ctrl+K,F",
     "In 3D, show how long a frame takes, what draws it, and of how much", kCheckable},
    {ExaggerateCopperHeight, MenuId::Solid, "Thick &copper", "C", "In 3D, draw copper ten times as thick as it is",
     kCheckable},
    {ExaggerateDielectricHeight, MenuId::Solid, "Thick &laminate", "V",
     "In 3D, draw all that is no copper five times as thick as it is", kCheckable},
    {SectionPlane, MenuId::Solid, "Cut &open", "X",
     "In 3D, cut the board open through the cursor, or through its middle; again to make it whole", kCheckable,
     kNewGroup},
    {RotateSectionPlane, MenuId::Solid, "&Turn the cut", "Shift+X", "Turn the cut by 45 degrees"},
    {MoveSectionPlaneOn, MenuId::Solid, "Cut &deeper", ".", "Move the cut, so that less of the board is left"},
    {MoveSectionPlaneBack, MenuId::Solid, "Cut &back", ",", "Move the cut, so that more of the board is left"},
    {ShowFlat, MenuId::Arrangement, "&2D alone", "2", "Show the flat view and nothing else", kCheckable},
    {ShowSolid, MenuId::Arrangement, "&3D alone", "3", "Show the solid view and nothing else", kCheckable},
    {ShowSideBySide, MenuId::Arrangement, "&Side by side", "4", "2D to the left of 3D", kCheckable},
    {ShowStacked, MenuId::Arrangement, "One &above the other", "5", "2D above 3D", kCheckable},
    {ShowLayersDock, MenuId::Panels, "&Layers", "Ctrl+1", "Show or hide the layers panel", kCheckable},
    {ShowNetsDock, MenuId::Panels, "&Nets", "Ctrl+5", "Show or hide the nets", kCheckable},
    {ShowElementDock, MenuId::Panels, "Ele&ment", "Ctrl+4", "Show or hide what is known of the selected element",
     kCheckable},
    {ShowNetCheckDock, MenuId::Panels, "O&pens and shorts", "Ctrl+7",
     "Show or hide how the copper differs from the nets", kCheckable},
    {ShowStackupDock, MenuId::Panels, "Stac&k", "Ctrl+6", "Show or hide the stack and its thicknesses", kCheckable},
    {ShowStatisticsDock, MenuId::Panels, "&Statistics", "Ctrl+2", "Show or hide the element statistics", kCheckable},
    {ShowSavedViewsDock, MenuId::Panels, "Kept vie&ws", "Ctrl+8", "Show or hide the views that were kept", kCheckable},
    {ShowClearanceDock, MenuId::Panels, "&Clearances", "Ctrl+9", "Show or hide narrow gaps, rules and the lens",
     kCheckable},
    {ShowMeasurementsDock, MenuId::Panels, "Meas&urements", "Ctrl+0", "Show or hide what was measured", kCheckable},
    {ShowSectionDock, MenuId::Panels, "Cr&oss-section", "Ctrl+Alt+0", "Show or hide the board cut open along a line",
     kCheckable},
    {ShowMessagesDock, MenuId::Panels, "Messa&ges", "Ctrl+3", "Show or hide what was skipped, repaired or assumed",
     kCheckable},
    {ShowToolBar, MenuId::Panels, "Toolba&r", "Ctrl+K,B", "Show or hide the toolbar", kCheckable},
    {NextPanel, MenuId::Panels, "Ne&xt panel", "F6", "Put the keyboard into the next view or panel", false, kNewGroup},
    {PreviousPanel, MenuId::Panels, "Pre&vious panel", "Shift+F6", "Put the keyboard into the view or panel before"},
    {ThemeSystem, MenuId::Theme, "As the &system", "Ctrl+K,S", "Colours of the desktop", kCheckable},
    {ThemeDark, MenuId::Theme, "&Dark", "Ctrl+K,D", "Light text on dark panels", kCheckable},
    {ThemeLight, MenuId::Theme, "&Light", "Ctrl+K,L", "Dark text on light panels", kCheckable},
    {BackendAuto, MenuId::Backend, "&Automatic", "Ctrl+K,A", "The one that suits this device", kCheckable},
    {BackendMesh, MenuId::Backend, "&Mesh shaders", "Ctrl+K,M", "Task and mesh shaders; the device must have them",
     kCheckable},
    {BackendPull, MenuId::Backend, "&Vertex pulling", "Ctrl+K,P",
     "Compute culling and indirect draws; works on every device", kCheckable},
    {BackendImpostor, MenuId::Backend, "&Exact outlines", "Ctrl+K,O",
     "Impostors: boxes whose pixels are cut by the true outlines; works on every device", kCheckable},
    {BackendRaster, MenuId::Backend, "&Compute rasterising", "Ctrl+K,R",
     "Compute shaders draw what is small, unsmoothed; the device must have 64-bit atomics", kCheckable},
    {KeysCopperscope, MenuId::Keys, "&Copperscope", "Ctrl+K,F1", "The keys this program comes with", kCheckable},
    {KeysKiCad, MenuId::Keys, "&KiCad", "Ctrl+K,F2", "Keys as in KiCad's board editor, where it has them", kCheckable},
    {KeysAltium, MenuId::Keys, "&Altium", "Ctrl+K,F3", "Keys as in Altium Designer, where it has them", kCheckable},
    {KeysAllegro, MenuId::Keys, "Alle&gro", "Ctrl+K,F4", "Keys as in Allegro, where it has them", kCheckable},
    {KeysKLayout, MenuId::Keys, "K&Layout", "Ctrl+K,F5", "Keys as in KLayout, where it has them", kCheckable},

    {ShowAllLayers, MenuId::Layers, "Show &all", "Ctrl+Shift+A", "Draw every layer"},
    {HideAllLayers, MenuId::Layers, "&Hide all", "Ctrl+Shift+H", "Draw no layer"},
    {ShowCopperOnly, MenuId::Layers, "&Copper only", "Ctrl+Shift+K", "Draw the copper layers and nothing else"},
    {SoloLayer, MenuId::Layers, "&Only this layer", "H", "Draw the current layer of the panel alone; again to go back"},
    {Contrast, MenuId::Layers, "High con&trast", "Shift+H",
     "In 2D, show the current layer of the panel brightly and all others faintly", kCheckable},
    {NextLayer, MenuId::Layers, "Layer &below", "PgDown", "Make the next visible layer the current one"},
    {PreviousLayer, MenuId::Layers, "Layer abo&ve", "PgUp", "Make the visible layer before the current one"},
    {RestoreLayers, MenuId::Layers, "&Default colours", "Ctrl+Shift+D",
     "Undo all changes of colour, opacity and visibility"},
    {SafeColours, MenuId::Layers, "Colo&ur-blind safe", "Ctrl+K,C",
     "Colours that are told apart without telling red from green", kCheckable},

    {ColourNet, MenuId::Nets, "&Colour the net", "U",
     "Give the highlighted nets, or the one under the cursor, a colour that stays; again to take it away"},
    {ChooseNetColour, MenuId::Nets, "C&hoose a colour…", "Shift+U",
     "Choose the colour of the highlighted nets, or of the one under the cursor"},
    {HideNet, MenuId::Nets, "H&ide the net", "Shift+N",
     "Do not draw the highlighted nets, or the one under the cursor, nor let them be clicked"},
    {ShowAllNets, MenuId::Nets, "&Show all nets", "Ctrl+Alt+N", "Draw all nets that were hidden", false, kNewGroup},
    {ClearNetColours, MenuId::Nets, "C&lear colours", "Ctrl+Alt+U", "Draw all nets in the colours of their layers"},

    {CheckNets, MenuId::Board, "&Check nets", "Ctrl+Shift+N",
     "Compare the nets with the copper: opens, shorts and loose copper"},
    {InferNets, MenuId::Board, "&Nets from the copper", "Ctrl+Shift+I",
     "Read the board again with nets found by following the copper, instead of the job's", kCheckable},
    {ExaggerateCopper, MenuId::Board, "E&xaggerate copper", "Ctrl+Shift+X",
     "In the drawing of the stack, make copper as thick as laminate; off: all to scale", kCheckable, kNewGroup},
    {ExportStackup, MenuId::Board, "Export &stack…", "Ctrl+Shift+E",
     "Write the stack as a drawing (SVG) or a table (CSV)"},
    {SearchClearances, MenuId::Board, "Measure clea&rances", "Ctrl+Shift+G",
     "Find the narrowest gaps, or what breaks the rules, as the Clearances panel asks", false, kNewGroup},
    {NextClearance, MenuId::Board, "Next &gap", "F8", "Show the next place of the Clearances panel in both views"},
    {PreviousClearance, MenuId::Board, "&Previous gap", "Shift+F8",
     "Show the place before in the Clearances panel in both views"},
    {EditRules, MenuId::Board, "Edit r&ules…", "Ctrl+Alt+R",
     "Edit what the board must keep: rules and the net classes they speak of"},
    {ExportClearances, MenuId::Board, "&Export clearances…", "Ctrl+Alt+G",
     "Write what was measured or checked as text, table or JSON, as the command line does"},
    {Lens, MenuId::Board, "Clearance &lens", "L",
     "Light up all copper of other nets that comes near what is selected or highlighted", kCheckable},
    {ClearanceMap, MenuId::Board, "Distance &map", "Shift+G",
     "Colour every place of a copper layer by its distance to what is selected, or by the gap between nets there",
     kCheckable},
    {DrawSection, MenuId::Board, "&Draw a section", "Shift+S",
     "Drag a line over the 2D view, or click its corners, to cut the board along it; corners can be moved afterwards",
     kCheckable, kNewGroup},
    {SectionAlongNet, MenuId::Board, "Section &along the net", "Ctrl+Alt+L",
     "Cut along the longest chain of strokes of the highlighted net, unrolled"},
    {OpenAlongSection, MenuId::Board, "&Open in 3D", "Alt+X",
     "Cut the board of the 3D view open along the straight line of the section"},
    {SaveSection, MenuId::Board, "&Keep the section", "Ctrl+Alt+B",
     "Keep the line of the section under a name, in the session file beside the board"},
    {ExportSection, MenuId::Board, "Expor&t section…", "Ctrl+Alt+E", "Write the section as a drawing (SVG)"},

    {MeasurePoints, MenuId::Measure, "&Point to point", "M",
     "Click two points in 2D or 3D to measure from one to the other; again to stop", kCheckable},
    {MeasureObjects, MenuId::Measure, "&Edge to edge", "Shift+M",
     "Click two elements to measure the gap between them, through the stack too; again to stop", kCheckable},
    {MeasureAngle, MenuId::Measure, "&Angle of three points", "A",
     "Click the corner and a point on each arm; again to stop", kCheckable},
    {MeasureLines, MenuId::Measure, "Angle of two &lines", "Shift+A",
     "Click two straight strokes or sides to measure the angle between them; again to stop", kCheckable},
    {MeasureRadius, MenuId::Measure, "&Radius", "Shift+R",
     "Click an arc, a round pad or a hole for its radius and diameter; again to stop", kCheckable},
    {MeasureLength, MenuId::Measure, "Length along a &net", "J Ctrl+J",
     "Click two places on a net to follow its copper from one to the other; again to stop", kCheckable},
    {MeasureSpacing, MenuId::Measure, "&Gap at the cursor", "R",
     "Measure from the copper nearest to the cursor to the next copper on its layer"},
    {ExportMeasurements, MenuId::Measure, "E&xport measurements…", "Ctrl+Alt+M",
     "Write all measurements as a table (CSV)", false, kNewGroup},

    {ClearSelection, MenuId::Select, "&Clear", "Esc",
     "Stop loading or checking, or else measuring or drawing, or else forget the selection, or else the highlighted "
     "nets"},
    {ShowSelection, MenuId::Select, "&Show in both views", "Z", "Bring what is selected to the middle of the views"},
    {SelectComponent, MenuId::Select, "Select the com&ponent", "P",
     "Select all pads, holes and the body of the component under the cursor, or of the selected element"},
    {SelectPin, MenuId::Select, "Select the p&in", "Shift+P",
     "Select all pads and the hole of the pin under the cursor, or of the selected element"},
    {SaveSelection, MenuId::Select, "&Keep this selection", "Ctrl+Shift+B",
     "Keep what is selected and highlighted under a name, in the session file beside the board"},
    {HighlightNet, MenuId::Select, "Highlight &net", "N",
     "Light up the whole net of the element under the cursor, or of the selected one; again to stop", false, kNewGroup},
    {DimOthers, MenuId::Select, "&Dim the rest", "D", "Darken everything that is not selected or highlighted",
     kCheckable},
    {FollowInSolid, MenuId::Select, "Follow in &3D", "Ctrl+K,3", "The 3D view goes to what is clicked in 2D",
     kCheckable, kNewGroup},
    {FollowInFlat, MenuId::Select, "Follow in &2D", "Ctrl+K,2", "The 2D view goes to what is clicked in 3D",
     kCheckable},
    {FollowInTables, MenuId::Select, "Follow in &tables", "Ctrl+K,T",
     "Tables go to the net of what is clicked in a view", kCheckable},
    {FollowFromTables, MenuId::Select, "Follow t&ables in views", "Ctrl+K,V",
     "Both views go to what is chosen in a table", kCheckable},
    {NextUnit, MenuId::Select, "Next &unit", "Q Ctrl+U", "Millimetres, mils, inches", false, kNewGroup},
    {ShowGrid, MenuId::Select, "&Grid and rulers", "G", "Show a grid and rulers in 2D", kCheckable},
    {ShowNames, MenuId::Select, "Net na&mes", "W", "Write the names of nets on the copper in 2D, where there is room",
     kCheckable},
    {ShowOutlines, MenuId::Select, "Out&lines alone", "S", "In 2D, draw outlines and nothing in them", kCheckable},
    {ShowPinNames, MenuId::Select, "Pin nam&es", "Shift+W",
     "Write the names of pins on their pads in 2D, where there is room", kCheckable},

    {ShowKeys, MenuId::Help, "&Keys and mouse", "F1 ?", "All keys and mouse gestures on one page"},
    {ResetSettings, MenuId::Help, "&Reset settings…", "Ctrl+K,Delete", "Forget window places, theme and recent boards",
     false, kNewGroup},
    {About, MenuId::Help, "&About Copperscope", "Shift+F1", "Version and licence", false, kNewGroup},
};
static_assert(std::size(kSpecs) == kActionCount);

constexpr const char* kMenuTitles[kMenuCount] = {
    "&File",   "&Edit", "&View",  "&Cut and thickness", "A&rrangement", "Pa&nels", "The&me", "Bac&k end", "Ke&ys as in",
    "&Layers", "&Nets", "&Board", "&Measure",           "&Select",      "&Help"};

bool isChoice(MenuId menu) {
    return menu == MenuId::Arrangement || menu == MenuId::Theme || menu == MenuId::Backend || menu == MenuId::Keys;
}

/// "Come closer (+ or =)"
QString tipWithKeys(const ActionSpec& spec, const QList<QKeySequence>& keys) {
    return QStringLiteral("%1 (%2)").arg(QString::fromUtf8(spec.tip), keysText(keys, QStringLiteral(" or ")));
}

}  // namespace

std::span<const ActionSpec> actionSpecs() {
    return kSpecs;
}

const char* menuTitle(MenuId menu) {
    return kMenuTitles[static_cast<std::size_t>(menu)];
}

QList<QKeySequence> keysFrom(const char* shortcuts) {
    QList<QKeySequence> keys;
    for (const QString& key : QString::fromUtf8(shortcuts).split(' ', Qt::SkipEmptyParts)) {
        keys += QKeySequence::fromString(key, QKeySequence::PortableText);
    }
    return keys;
}

ActionSet::ActionSet(QWidget& window) : m_window(window) {
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
    action.setText(QString::fromUtf8(spec.text));
    action.setStatusTip(QString::fromUtf8(spec.tip));
    action.setCheckable(spec.isCheckable);
    applyKeys(spec, action);
    m_window.addAction(&action);
}

void ActionSet::applyKeys(const ActionSpec& spec, QAction& action) const {
    const QList<QKeySequence> keys = keysOf(spec, m_keys);
    action.setShortcuts(keys);
    action.setToolTip(tipWithKeys(spec, keys));
}

void ActionSet::setKeys(KeyPreset keys) {
    m_keys = keys;
    for (const ActionSpec& spec : kSpecs) {
        applyKeys(spec, (*this)[spec.id]);
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
        if (spec.beginsGroup) {
            menu.addSeparator();
        }
        menu.addAction(&(*this)[spec.id]);
    }
}

}  // namespace ui
