#pragma once

#include <QAction>
#include <QList>
#include <QObject>
#include <QString>
#include <array>

class QMenu;
class QWidget;

/// Every command of the workbench, declared in one table: menus, toolbar, shortcuts, tips and the list of keys come
/// from it.
namespace ui {

// A menu a line or more, in the order of the table.
// clang-format off
enum class ActionId {
    OpenFile, OpenFolder, Reload, AssignLayers, CancelLoading, SaveSession, ExportBoard, PrintBoard, SavePicture, SaveLargePicture, CopyPicture,
    Quit,
    Undo, Redo, Find, Commands,
    Fit, ViewTop, ViewBottom, ViewIso, Flip, ZoomIn, ZoomOut, ViewBack, ViewForward, SaveView, Orthographic, Explode,
    ShowViewCube, ShowFrameDisplay,
    ExaggerateCopperHeight, ExaggerateDielectricHeight, ShowMilledAway, SectionPlane, RotateSectionPlane, MoveSectionPlaneOn,
    MoveSectionPlaneBack,
    ShowFlat, ShowSolid, ShowSideBySide, ShowStacked,
    UseGeneral, UseStackup, UseNets, UseClearance, RestorePanels,
    ShowLayersDock, ShowNetsDock, ShowElementDock, ShowNetCheckDock, ShowStackupDock, ShowStatisticsDock,
    ShowSavedViewsDock, ShowClearanceDock, ShowMeasurementsDock, ShowSectionDock, ShowPartsDock, ShowPinsDock,
    ShowComparisonDock, ShowMessagesDock, ShowToolBar,
    NextPanel, PreviousPanel,
    ThemeSystem, ThemeDark, ThemeLight,
    BackendAuto, BackendMesh, BackendPull, BackendImpostor, BackendRaster,
    KeysCopperscope, KeysKiCad, KeysAltium, KeysAllegro, KeysKLayout,
    ShowDefaultLayers, ShowAllLayers, HideAllLayers, ShowCopperOnly, ShowTopLayers, ShowBottomLayers, ShowInnerLayers,
    ShowAssemblyLayers, ShowFabricationLayers, ShowComponents, SaveLayerSet, SoloLayer, Contrast, NextLayer, PreviousLayer, TopCopper,
    BottomCopper, NoCurrentLayer, RestoreLayers, SafeColours,
    ColourNet, ChooseNetColour, HideNet, IsolateNet, ShowAllNets, ClearNetColours,
    CheckNets, InferNets, CompareFile, CompareFolder, ExaggerateCopper, ExportStackup, SearchClearances, NextClearance, PreviousClearance,
    CheckRules, EditRules, ExportClearances, Lens, ClearanceMap, DrawSection, SectionAlongNet, OpenAlongSection,
    SaveSection, ExportSection,
    MeasurePoints, MeasureObjects, MeasureAngle, MeasureLines, MeasureRadius, MeasureLength, MeasureSpacing,
    ShowMeasurements, DeleteMeasurements, ExportMeasurements,
    ClearSelection, ShowSelection, SelectComponent, SelectPin, SaveSelection, HighlightNet, AddNet, DimOthers, FollowInSolid,
    FollowInFlat, FollowInTables, FollowFromTables,
    NextUnit, ShowGrid, ShowNames, ShowOutlines, ShowPinNames,
    ShowGuide, ShowKeys, ResetSettings, About,
    Count
};
// clang-format on
inline constexpr std::size_t kActionCount = static_cast<std::size_t>(ActionId::Count);

/// Where a command is found. Solid (what the 3D view draws otherwise) and Panels are submenus of View; so are
/// Arrangement (of the views), Uses (of the window), Theme, Backend and Keys, with one choice each.
enum class MenuId {
    File,
    Edit,
    View,
    Solid,
    Arrangement,
    Uses,
    Panels,
    Theme,
    Backend,
    Keys,
    Layers,
    Nets,
    Board,
    Measure,
    Select,
    Help,
    Count
};
inline constexpr std::size_t kMenuCount = static_cast<std::size_t>(MenuId::Count);

struct ActionSpec {
    ActionId id;
    MenuId menu;
    const char* text;       ///< for ActionSet::tr, with & before the mnemonic
    const char* shortcuts;  ///< portable text, several separated by blanks; "Ctrl+K,D" are two keys one after the other
    const char* tip;
    unsigned flags = 0;      ///< as below
    const char* words = "";  ///< others that people look for it by, for ActionSet::tr, separated by blanks
};
inline constexpr unsigned kCheckable = 1U;
inline constexpr unsigned kNewGroup = 2U;  ///< a separator goes before it
inline constexpr unsigned kNeedsBoard = 4U;
/// What it does, or switches on, is seen in the 2D view alone, which is shown for it where it is hidden. Commands that
/// may have nothing to do call BoardViews::reveal where they do something instead.
inline constexpr unsigned kInFlat = 8U;
inline constexpr unsigned kInSolid = 16U;  ///< in the 3D view alone, likewise

[[nodiscard]] QString menuTitle(MenuId menu);
/// Keys written as in ActionSpec::shortcuts.
[[nodiscard]] QList<QKeySequence> keysFrom(const char* shortcuts);

/// Which program has these keys, see key_presets.h.
enum class KeyPreset { Copperscope, KiCad, Altium, Allegro, KLayout };

/// The live actions of one window.
class ActionSet : public QObject {
    Q_OBJECT

public:
    /// Makes all actions children of `window`, so that their shortcuts work wherever the focus is inside it.
    explicit ActionSet(QWidget& window);

    static const ActionSpec kSpecs[kActionCount];  ///< in menu order; row n has id n
    static const char* const kMenuTitles[kMenuCount];

    [[nodiscard]] QAction& operator[](ActionId id) const { return *m_actions[static_cast<std::size_t>(id)]; }
    /// Uses an action that a widget made itself (a dock's own toggle) in place of ours.
    void adopt(ActionId id, QAction& action);
    /// Appends the actions of `menu` in table order.
    void fill(QMenu& menu, MenuId id) const;
    /// Enables or disables all that need a board.
    void enable(bool hasBoard) const;
    /// Gives all actions the keys of another program, in tips too.
    void setKeys(KeyPreset keys);
    [[nodiscard]] KeyPreset keys() const { return m_keys; }

private:
    void apply(const ActionSpec& spec, QAction& action) const;
    void applyKeys(const ActionSpec& spec, QAction& action) const;

    QWidget& m_window;
    KeyPreset m_keys = KeyPreset::Copperscope;
    std::array<QAction*, kActionCount> m_actions{};
};

}  // namespace ui
