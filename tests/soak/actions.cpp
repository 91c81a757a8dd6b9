#include "tests/soak/actions.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest>
#include <algorithm>
#include <array>
#include <numeric>

#include "ui/common/paths.h"
#include "ui/comparison/comparison_feature.h"
#include "ui/export/export_dialog.h"

namespace soak {

using ui::ActionId;
using ui::BoardView;

namespace {

constexpr ActionId kViewKeys[] = {
    ActionId::Fit,      ActionId::ViewTop,   ActionId::ViewBottom,     ActionId::ViewIso,     ActionId::Flip,
    ActionId::ZoomIn,   ActionId::ZoomOut,   ActionId::ViewBack,       ActionId::ViewForward, ActionId::Orthographic,
    ActionId::ShowFlat, ActionId::ShowSolid, ActionId::ShowSideBySide, ActionId::ShowStacked};
constexpr ActionId kMeasuringTools[] = {ActionId::MeasurePoints, ActionId::MeasureObjects, ActionId::MeasureAngle,
                                        ActionId::MeasureLines,  ActionId::MeasureRadius,  ActionId::MeasureLength,
                                        ActionId::MeasureSpacing};
constexpr ActionId kHeights[] = {ActionId::Explode, ActionId::ExaggerateCopperHeight,
                                 ActionId::ExaggerateDielectricHeight, ActionId::ShowMilledAway};
constexpr ActionId kPlane[] = {ActionId::SectionPlane, ActionId::RotateSectionPlane, ActionId::MoveSectionPlaneOn,
                               ActionId::MoveSectionPlaneBack, ActionId::OpenAlongSection};
constexpr ActionId kNetStyles[] = {ActionId::ColourNet,   ActionId::HideNet,         ActionId::IsolateNet,
                                   ActionId::ShowAllNets, ActionId::ClearNetColours, ActionId::HighlightNet,
                                   ActionId::AddNet,      ActionId::DimOthers};
constexpr ActionId kBackends[] = {ActionId::BackendAuto, ActionId::BackendMesh, ActionId::BackendPull,
                                  ActionId::BackendImpostor, ActionId::BackendRaster};
const char* const kPanels[] = {"layers",     "nets",         "element", "netCheck", "stackup", "statistics", "views",
                               "clearances", "measurements", "section", "parts",    "pins",    "messages"};
const char* const kSought[] = {"GND", "u1", "r", "c1", "vcc", "top", "10 20", ">flip", "no such thing", "1"};
const char* const kThicknesses[] = {"0.2 mm", "1 oz", "8 mil", "", "35 um", "thick"};

template <class List>
auto oneOf(const List& list, Dice& dice) {
    return list[dice.below(std::size(list))];
}

QComboBox& boxOf(Driver& driver, const char* name) {
    return *driver.window().panel("clearances").findChild<QComboBox*>(name);
}

void open(Driver& driver, Dice& dice) {
    driver.open(dice.below(driver.boards().size()));
}

void reload(Driver& driver, Dice&) {
    driver.trigger(ActionId::Reload);
}

void restart(Driver& driver, Dice& dice) {
    driver.restart();
    open(driver, dice);
}

void cancel(Driver& driver, Dice&) {
    driver.key(Qt::Key_Escape);
}

void settle(Driver& driver, Dice&) {
    driver.settle();
}

void rest(Driver& driver, Dice& dice) {
    driver.rest(dice.between(0, 300));
}

void select(Driver& driver, Dice& dice) {
    constexpr Qt::KeyboardModifier kWith[] = {Qt::NoModifier, Qt::NoModifier, Qt::ControlModifier, Qt::AltModifier};
    BoardView& view = driver.view(dice);
    const QPointF at = Driver::locationIn(view, dice);
    if (dice.oneIn(6)) {
        driver.doubleClick(view, at);
    } else {
        driver.click(view, at, Qt::LeftButton, oneOf(kWith, dice));
    }
}

void openMenu(Driver& driver, Dice& dice) {
    BoardView& view = driver.view(dice);
    driver.click(view, Driver::locationIn(view, dice), Qt::RightButton);
}

void drag(Driver& driver, Dice& dice) {
    constexpr Qt::MouseButton kButtons[] = {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
    BoardView& view = driver.view(dice);
    const QPointF from = Driver::locationIn(view, dice);
    driver.drag(view, from, Driver::locationIn(view, dice), oneOf(kButtons, dice));
}

void zoom(Driver& driver, Dice& dice) {
    BoardView& view = driver.view(dice);
    const QPointF at = Driver::locationIn(view, dice);
    const int notches = dice.between(1, 6);
    const int sign = dice.oneIn(2) ? 1 : -1;
    for (int i = 0; i < notches; ++i) {
        driver.wheel(view, at, sign);
    }
}

void hover(Driver& driver, Dice& dice) {
    BoardView& view = driver.view(dice);
    for (int i = 0; i < 5; ++i) {
        driver.move(view, Driver::locationIn(view, dice));
    }
}

void look(Driver& driver, Dice& dice) {
    driver.trigger(oneOf(kViewKeys, dice));
}

void command(Driver& driver, Dice& dice) {
    const std::size_t drawn = dice.below(ui::kActionCount);
    if (static_cast<ActionId>(drawn) != ActionId::Quit) {
        driver.trigger(static_cast<ActionId>(drawn));
    }
}

void chooseBackend(Driver& driver, Dice& dice) {
    driver.trigger(oneOf(kBackends, dice));
}

void showLayer(Driver& driver, Dice& dice) {
    const std::size_t drawn = dice.next();
    ui::LayerModel& layers = driver.window().layers();
    const QModelIndex box =
        layers.index(static_cast<int>(drawn % static_cast<std::size_t>(layers.rowCount())), ui::LayerModel::Visible);
    const bool isOn = layers.data(box, Qt::CheckStateRole).toBool();
    layers.setData(box, isOn ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
    driver.rest(1);
}

void showPanel(Driver& driver, Dice& dice) {
    driver.window().showPanel(oneOf(kPanels, dice));
    driver.rest(1);
}

void measure(Driver& driver, Dice& dice) {
    driver.trigger(oneOf(kMeasuringTools, dice));
    BoardView& view = driver.view(dice);
    for (int i = 0; i < 3; ++i) {
        driver.click(view, Driver::locationIn(view, dice));
    }
}

void drawSection(Driver& driver, Dice& dice) {
    BoardView& flat = driver.window().views().flat();
    const QPointF from = Driver::locationIn(flat, dice);
    const QPointF to = Driver::locationIn(flat, dice);
    driver.trigger(ActionId::DrawSection);
    driver.drag(flat, from, to, Qt::LeftButton);
    if (dice.oneIn(3)) {
        driver.trigger(ActionId::SaveSection);
    }
}

void cutOpen(Driver& driver, Dice& dice) {
    driver.trigger(oneOf(kPlane, dice));
}

void raise(Driver& driver, Dice& dice) {
    driver.trigger(oneOf(kHeights, dice));
}

void checkRules(Driver& driver, Dice& dice) {
    QComboBox& what = boxOf(driver, "what");
    QComboBox& where = boxOf(driver, "where");
    what.setCurrentIndex(static_cast<int>(dice.below(3)));
    where.setCurrentIndex(static_cast<int>(dice.below(4)));
    driver.trigger(ActionId::SearchClearances);
}

void walkFindings(Driver& driver, Dice& dice) {
    driver.trigger(dice.oneIn(3) ? ActionId::PreviousClearance : ActionId::NextClearance);
}

void lookAtClearances(Driver& driver, Dice& dice) {
    driver.trigger(dice.oneIn(2) ? ActionId::Lens : ActionId::ClearanceMap);
}

void checkNets(Driver& driver, Dice&) {
    driver.trigger(ActionId::CheckNets);
}

/// With another board, which may be the same, and a row of what comes out.
void compare(Driver& driver, Dice& dice) {
    const std::size_t other = dice.below(driver.boards().size());
    const bool isAwaited = dice.oneIn(2);
    driver.window().showPanel("comparison");
    driver.window().find<ui::ComparisonFeature>().start(ui::fromPath(driver.boards()[other]));
    if (isAwaited) {
        driver.settle();
    }
    driver.clickRow(driver.window().table("comparison"), dice);
}

void exportBoard(Driver& driver, Dice& dice) {
    const std::size_t format = dice.below(model::exportFormats().size());
    const std::uint64_t number = dice.below(1000);
    driver.trigger(ActionId::ExportBoard);
    const QPointer<ui::ExportDialog> dialog = driver.window().findChild<ui::ExportDialog*>();
    if (!dialog) {
        return;  // one is being written
    }
    dialog->findChild<QComboBox*>("exportFormat")->setCurrentIndex(static_cast<int>(format));
    auto& line = *dialog->findChild<QLineEdit*>("exportFile");
    const QString ending = line.text().section('.', -1);
    line.setText(QStringLiteral("%1/%2.%3").arg(ui::fromPath(driver.outputFolder())).arg(number).arg(ending));
    driver.rest(dice.between(0, 400));
    if (dialog) {
        QTest::keyClick(&line, Qt::Key_Return);
    }
    driver.rest(1);
}

void savePicture(Driver& driver, Dice& dice) {
    const int width = dice.between(100, 2000);
    driver.window().savePicture(ui::fromPath(driver.outputFolder() / "picture.png"), width);
    driver.rest(1);
}

void find(Driver& driver, Dice& dice) {
    const char* text = oneOf(kSought, dice);
    const bool isTaken = dice.oneIn(2);
    driver.trigger(ActionId::Find);
    QLineEdit& line = driver.window().searchBox().line();
    QTest::keyClicks(&line, text);
    driver.rest(1);
    QTest::keyClick(&line, isTaken ? Qt::Key_Return : Qt::Key_Escape);
    if (driver.window().searchBox().isVisible()) {
        QTest::keyClick(&line, Qt::Key_Escape);
    }
    driver.rest(1);
}

void chooseRow(Driver& driver, Dice& dice) {
    constexpr const char* kTables[] = {"nets", "parts", "clearances", "comparison", "measurements", "messages"};
    const char* panel = oneOf(kTables, dice);
    driver.window().showPanel(panel);
    driver.clickRow(driver.window().table(panel), dice);
}

void styleNets(Driver& driver, Dice& dice) {
    driver.trigger(oneOf(kNetStyles, dice));
}

void undo(Driver& driver, Dice& dice) {
    driver.trigger(dice.oneIn(3) ? ActionId::Redo : ActionId::Undo);
}

void editThickness(Driver& driver, Dice& dice) {
    const std::size_t drawn = dice.next();
    const char* text = oneOf(kThicknesses, dice);
    ui::StackupModel& stack = driver.window().stack();
    if (stack.layerCount() > 0) {
        const int row = static_cast<int>(drawn % static_cast<std::size_t>(stack.layerCount()));
        stack.setData(stack.index(row, stack.columnOf(ui::StackupModel::Thickness)), QString(text), Qt::EditRole);
    }
    driver.rest(1);
}

void resize(Driver& driver, Dice& dice) {
    const int width = dice.between(500, 1500);
    driver.window().resize(width, dice.between(400, 950));
    driver.rest(5);
}

void minimise(Driver& driver, Dice& dice) {
    driver.window().showMinimized();
    driver.rest(dice.between(1, 50));
    driver.window().showNormal();
    driver.window().activateWindow();
    driver.rest(5);
}

void saveSession(Driver& driver, Dice&) {
    driver.trigger(ActionId::SaveSession);
}

void loseDevice(Driver& driver, Dice& dice) {
    driver.settle();
    driver.context().device().inject({.loseAtSubmission = static_cast<std::uint64_t>(dice.between(1, 4))});
    driver.window().views().solid().requestFrame();
    driver.window().views().flat().requestFrame();
    driver.settle();
    driver.rest(200);
}

void runOutOfMemory(Driver& driver, Dice& dice) {
    driver.settle();
    driver.context().device().inject({.failAllocation = static_cast<std::uint64_t>(dice.between(1, 6))});
    driver.open(dice.below(driver.boards().size()));
    driver.settle();
    driver.context().device().inject({});
    driver.rest(200);
}

// A row a line: the table is read by columns.
// clang-format off
constexpr Action kActions[] = {
    {"open", 3, false, false, open},
    {"reload", 1, true, false, reload},
    {"restart", 1, false, false, restart},
    {"cancel", 4, false, false, cancel},
    {"settle", 8, false, false, settle},
    {"rest", 15, false, false, rest},
    {"select", 14, true, false, select},
    {"menu", 3, true, false, openMenu},
    {"drag", 10, true, false, drag},
    {"zoom", 10, true, false, zoom},
    {"hover", 8, true, false, hover},
    {"look", 10, true, false, look},
    {"command", 12, false, false, command},
    {"backend", 1, true, false, chooseBackend},
    {"layer", 6, true, false, showLayer},
    {"panel", 5, false, false, showPanel},
    {"measure", 8, true, false, measure},
    {"section", 5, true, false, drawSection},
    {"plane", 4, true, false, cutOpen},
    {"heights", 3, true, false, raise},
    {"rules", 3, true, false, checkRules},
    {"finding", 4, true, false, walkFindings},
    {"clearances", 3, true, false, lookAtClearances},
    {"netcheck", 1, true, false, checkNets},
    {"compare", 1, true, false, compare},
    {"export", 3, true, false, exportBoard},
    {"picture", 1, true, false, savePicture},
    {"find", 4, true, false, find},
    {"row", 6, true, false, chooseRow},
    {"nets", 4, true, false, styleNets},
    {"undo", 5, true, false, undo},
    {"thickness", 2, true, false, editThickness},
    {"resize", 3, false, false, resize},
    {"minimise", 1, false, false, minimise},
    {"session", 2, true, false, saveSession},
    {"lose-device", 2, true, true, loseDevice},
    {"no-memory", 2, false, true, runOutOfMemory},
};
// clang-format on

}  // namespace

std::span<const Action> actions() {
    return kActions;
}

const Action& drawAction(Dice& dice, bool withFaults) {
    const auto weightOf = [&](const Action& action) { return action.isFault && !withFaults ? 0 : action.weight; };
    const int all = std::accumulate(std::begin(kActions), std::end(kActions), 0,
                                    [&](int sum, const Action& action) { return sum + weightOf(action); });
    int drawn = static_cast<int>(dice.below(static_cast<std::size_t>(all)));
    const auto taken = std::ranges::find_if(kActions, [&](const Action& action) {
        drawn -= weightOf(action);
        return drawn < 0;
    });
    return *taken;
}

}  // namespace soak
