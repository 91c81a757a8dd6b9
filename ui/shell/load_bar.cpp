#include "ui/shell/load_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace ui {

LoadBar::LoadBar(QWidget* parent)
    : QWidget(parent), m_label(new QLabel), m_bar(new QProgressBar), m_cancel(new QToolButton) {
    m_bar->setRange(0, 100);
    m_bar->setFixedWidth(140);
    m_bar->setMaximumHeight(fontMetrics().height() + 4);
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Stop reading; the board on the screen stays (Esc)"));
    connect(m_cancel, &QToolButton::clicked, this, &LoadBar::cancelRequested);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->addWidget(m_label);
    layout->addWidget(m_bar);
    layout->addWidget(m_cancel);
    hide();
}

void LoadBar::begin(const QString& name) {
    m_name = name;
    report(tr("Opening"), 0.0);
    show();
}

void LoadBar::report(const QString& phase, double fraction) {
    m_label->setText(QStringLiteral("%1: %2").arg(m_name, phase));
    m_bar->setValue(static_cast<int>(fraction * 100.0));
}

QString LoadBar::text() const {
    return m_label->text();
}

}  // namespace ui
