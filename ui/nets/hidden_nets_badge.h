#pragma once

#include <QToolButton>

namespace ui {

class NetStyles;

/// A button of the status line that says how many nets are hidden, so that nobody takes what is left for the board;
/// they stay hidden when the board is opened again. A click shows them all. Itself hidden while all nets are shown.
class HiddenNetsBadge : public QToolButton {
    Q_OBJECT

public:
    /// `showAll`: the command that shows all nets.
    HiddenNetsBadge(const NetStyles& styles, QAction& showAll, QWidget* parent = nullptr);

private:
    void refresh();

    const NetStyles& m_styles;
};

}  // namespace ui
