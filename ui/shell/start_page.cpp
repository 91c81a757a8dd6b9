#include "ui/shell/start_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/workspace/actions.h"

namespace ui {

namespace {

QPushButton* buttonFor(QAction& action) {
    auto* button = new QPushButton(action.text());
    button->setToolTip(action.toolTip());
    QObject::connect(button, &QPushButton::clicked, &action, &QAction::trigger);
    return button;
}

QLabel* centredLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setAlignment(Qt::AlignCenter);
    return label;
}

}  // namespace

StartPage::StartPage(const ActionSet& actions, QWidget* parent) : QWidget(parent) {
    QLabel* title = centredLabel(QStringLiteral("Copperscope"));
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() * 2.0);
    title->setFont(large);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(buttonFor(actions[ActionId::OpenFile]));
    buttons->addWidget(buttonFor(actions[ActionId::OpenFolder]));
    buttons->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addStretch();
    layout->addWidget(title);
    layout->addWidget(centredLabel(tr("Drop an ODB++ archive or folder here, or open one.")));
    layout->addLayout(buttons);
    layout->addStretch();
}

}  // namespace ui
