#include "ui/nets/hidden_nets_badge.h"

#include <QAction>
#include <algorithm>

#include "ui/nets/net_styles.h"

namespace ui {

HiddenNetsBadge::HiddenNetsBadge(const NetStyles& styles, QAction& showAll, QWidget* parent)
    : QToolButton(parent), m_styles(styles) {
    setObjectName(QStringLiteral("hiddenNets"));
    setFocusPolicy(Qt::NoFocus);
    setStyleSheet(QStringLiteral("QToolButton { font-weight: bold; }"));
    setToolTip(
        tr("Nets that are not drawn and not clicked, also when the board is opened again. Click to show all (%1)")
            .arg(showAll.shortcut().toString(QKeySequence::NativeText)));
    connect(&styles, &NetStyles::changed, this, &HiddenNetsBadge::refresh);
    connect(this, &QToolButton::clicked, &showAll, &QAction::trigger);
    hide();
}

void HiddenNetsBadge::refresh() {
    const auto count = std::ranges::count_if(m_styles.state(), &NetStyle::isHidden);
    setText(count == 1 ? tr("1 net hidden") : tr("%L1 nets hidden").arg(count));
    setVisible(count > 0);
}

}  // namespace ui
