#pragma once

#include <QPointF>
#include <filesystem>
#include <memory>
#include <vector>

#include "tests/soak/dice.h"
#include "tests/ui/window_fixture.h"

class QDialog;

namespace soak {

/// Hands that use a window: events as mouse and keyboard send them, with the event loop running in between as it does
/// for people.
class Driver {
public:
    /// Boards are copied where the window may write beside them.
    explicit Driver(const std::vector<std::filesystem::path>& boards);

    [[nodiscard]] TestWindow& window() { return m_fixture.window(); }
    [[nodiscard]] WindowFixture& fixture() { return m_fixture; }
    [[nodiscard]] ui::GpuContext& context() { return m_fixture.context(); }
    [[nodiscard]] bool hasBoard() { return window().document() != nullptr; }
    [[nodiscard]] const std::vector<std::filesystem::path>& boards() const { return m_boards; }
    /// Where exports go: a folder that nothing else writes to.
    [[nodiscard]] std::filesystem::path outputFolder() const;
    /// Names in it.
    [[nodiscard]] std::vector<std::string> outputs() const;
    void removeOutputs() const;
    /// Files that a program writes before they get their name, and left: in the output folder and beside the boards.
    [[nodiscard]] std::vector<std::string> unfinishedFiles() const;

    /// Closes the window and makes another one, as in the next run of the program.
    void restart();
    /// Opens a board; what follows comes with the event loop.
    void open(std::size_t board);
    /// Runs the event loop.
    void rest(int ms);
    /// Until no work is left and all is drawn; false if that takes longer.
    bool settle(int mostMs = 60'000);
    /// Until cancelled work has wound down, so that there are no more threads than that; false if that takes longer.
    bool awaitThreads(std::size_t count, int mostMs = 60'000);

    /// A view that is on the screen.
    [[nodiscard]] ui::BoardView& view(Dice& dice);
    [[nodiscard]] static QPointF locationIn(ui::BoardView& view, Dice& dice);
    void move(ui::BoardView& view, QPointF to, Qt::MouseButton held = Qt::NoButton);
    void click(ui::BoardView& view, QPointF at, Qt::MouseButton button = Qt::LeftButton,
               Qt::KeyboardModifiers modifiers = {});
    void doubleClick(ui::BoardView& view, QPointF at);
    void drag(ui::BoardView& view, QPointF from, QPointF to, Qt::MouseButton button,
              Qt::KeyboardModifiers modifiers = {});
    void wheel(ui::BoardView& view, QPointF at, int notches);
    /// Types on the view in use.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
    /// Types Esc while something is worked out; false if that had ended before.
    [[nodiscard]] bool stopWork();
    /// As its menu does: not while it is disabled.
    void trigger(ui::ActionId id);
    /// A row of the table in a panel, by a click.
    void clickRow(ui::TableView& table, Dice& dice);
    /// Ends menus and dialogs: takes a choice, accepts or gives up.
    void answerAll(Dice& dice);

private:
    void activate();
    void send(ui::BoardView& view, QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held,
              Qt::KeyboardModifiers modifiers);
    void answerMenu(Dice& dice);
    void answerDialog(QDialog& dialog, Dice& dice);

    WindowFixture m_fixture;
    std::vector<std::filesystem::path> m_boards;
};

}  // namespace soak
