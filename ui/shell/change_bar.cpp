#include "ui/shell/change_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace ui {

ChangeBar::ChangeBar(QWidget* parent) : QFrame(parent) {
    auto* reload = new QPushButton(tr("&Reload"));
    reload->setToolTip(tr("Read the board again; view, layers and selection stay"));
    auto* ignore = new QPushButton(tr("&Ignore"));
    ignore->setToolTip(tr("Keep what is on the screen until the files change once more"));
    connect(reload, &QPushButton::clicked, this, &QWidget::hide);
    connect(reload, &QPushButton::clicked, this, &ChangeBar::reloadRequested);
    connect(ignore, &QPushButton::clicked, this, &QWidget::hide);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 6, 4);
    layout->addWidget(new QLabel(tr("The files of this board changed on the disk.")));
    layout->addWidget(reload);
    layout->addWidget(ignore);
    layout->addStretch();
    hide();
}

}  // namespace ui
