#pragma once

#include <QFrame>

#include "ui/search/board_search.h"

class QAction;
class QLineEdit;
class QListWidget;

namespace ui {

class ActionSet;
struct ActionSpec;

/// One line to find anything by: nets, components, pins, attributes, layers, locations and commands, shown while
/// typing. Up and Down choose, Enter takes, Esc closes. A text that begins with > finds commands alone.
class SearchBox : public QFrame {
    Q_OBJECT

public:
    SearchBox(const ActionSet& actions, QWidget& window);

    /// What is listed is looked for again.
    void setBoard(std::shared_ptr<const model::Document> board);
    [[nodiscard]] const BoardSearch& search() const { return m_search; }
    void setUnit(LengthUnit unit) { m_unit = unit; }
    /// Appears over the window with `text` in its line.
    void open(const QString& text);
    [[nodiscard]] QLineEdit& line() { return *m_line; }
    [[nodiscard]] QListWidget& list() { return *m_list; }

signals:
    void chosen(const Found& found);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Where the words of a text are, the best first: it is one of the command's other words, they are in the name as
    /// they stand, each somewhere in name and other words, in menu and name, in what the command does too.
    enum class CommandFit { Word, Phrase, Name, Menu, Tip, None };

    void update();
    [[nodiscard]] CommandFit fitOf(const ActionSpec& spec, const QString& text) const;
    /// By name and other words; alone in the list, also by their menu and what they do.
    void listCommands(const QString& text, bool areAlone);
    void addCommand(const ActionSpec& spec);
    void take();

    const ActionSet& m_actions;
    QWidget& m_window;
    BoardSearch m_search;
    LengthUnit m_unit = LengthUnit::Millimetre;
    std::vector<Found> m_found;        ///< the first rows of the list
    std::vector<QAction*> m_commands;  ///< the rest
    QLineEdit* m_line;
    QListWidget* m_list;
};

}  // namespace ui
