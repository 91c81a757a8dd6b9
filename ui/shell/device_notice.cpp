#include "ui/shell/device_notice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/workspace/settings.h"

namespace ui {

DeviceNotice::DeviceNotice(const render::gpu::Caps& caps, Settings& settings, QWidget* parent) : QFrame(parent) {
    if (!caps.isCpu || settings.knowsOfSoftwareDevice()) {
        hide();
        return;
    }
    settings.setKnowsOfSoftwareDevice();
    auto* text =
        new QLabel(tr("No graphics card is in use: the processor draws (%1). All works, but moving a large board "
                      "in 3D is slow. If there is a card in this machine, its Vulkan driver is missing.")
                       .arg(QString::fromStdString(caps.name)));
    text->setObjectName(QStringLiteral("softwareDevice"));
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    auto* close = new QPushButton(tr("&Understood"));
    connect(close, &QPushButton::clicked, this, &QWidget::hide);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 6, 4);
    layout->addWidget(text, 1);
    layout->addWidget(close);
}

}  // namespace ui
