#include "ui/views/height_controls.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <utility>

#include "ui/views/board_views.h"
#include "ui/workspace/read_anew.h"

namespace ui {

namespace {

/// How many times as thick layers are drawn when they are to be seen.
constexpr float kCopperScale = 10.0F;
constexpr float kDielectricScale = 5.0F;
constexpr int kMostScale = 20;
/// The slider of the spread moves in twentieths of what the command does.
constexpr int kSpreadSteps = 20;
constexpr int kMostSpread = 3 * kSpreadSteps;

constexpr int kSliderWidth = 70;
constexpr double kMargin = 8.0;
constexpr double kPadding = 6.0;
constexpr QColor kGround(20, 22, 26, 190);
constexpr QColor kInk(255, 205, 90);

/// The layer of what is selected; of a highlighted net, its first copper.
model::LayerId layerOfSelection(const SelectionModel& selection) {
    if (const auto at = selection.current()) {
        return selection.layerOf(*at);
    }
    for (const model::BoardNet& net : selection.nets()) {
        const model::Document& step = *selection.tree().steps[net.step];
        for (const model::ElementId element : step.elementsOf(net.net)) {
            const model::LayerId layer = step.elements.layer[element.row()];
            if (step.layer(layer).isCopper()) {
                return step.layerOfCopy(layer, selection.tree().copies[selection.firstCopyOf(net.step)].isFlipped);
            }
        }
    }
    return {};
}

}  // namespace

HeightControls::HeightControls(BoardViews& views, Workspace& workspace, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_views(views), m_actions(actions) {
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(2, 0, 6, 0);
    row->setSpacing(4);
    m_spread = addSlider("spread", 0, kMostSpread,
                         tr("How far the layers are spread apart in 3D; double-click to put them together"));
    row->addWidget(new QLabel(tr("Height")));
    m_scale = addSlider("heightScale", 1, kMostScale,
                        tr("Vertical scale of all layers in 3D; double-click for their true thickness"));
    connect(m_spread, &QSlider::valueChanged, this, &HeightControls::onSpread);
    connect(m_scale, &QSlider::valueChanged, this, &HeightControls::applyScale);
    connect(&actions[ActionId::Explode], &QAction::triggered, this, &HeightControls::onExplode);
    for (const ActionId id : {ActionId::ExaggerateCopperHeight, ActionId::ExaggerateDielectricHeight}) {
        connect(&actions[id], &QAction::triggered, this, &HeightControls::applyScale);
    }
    connect(&workspace, &Workspace::boardLeaves, this,
            [this, &workspace](const LoadedBoard& next) { m_isReadAnew = isReadAnew(workspace, next); });
    connect(&workspace, &Workspace::boardShown, this, &HeightControls::onBoard);
    views.setAnchor([&workspace] { return layerOfSelection(workspace.selection()); });
    views.solid().addPainter([this](QPainter& painter) { paint(painter); });
}

QSlider* HeightControls::addSlider(const char* name, int least, int most, const QString& tip) {
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setObjectName(QLatin1String(name));
    slider->setAccessibleName(tip);
    slider->setRange(least, most);
    slider->setFixedWidth(kSliderWidth);
    slider->setFocusPolicy(Qt::TabFocus);  // keys stay with the view that is looked at
    slider->setToolTip(tip);
    slider->installEventFilter(this);
    connect(slider, &QSlider::actionTriggered, &m_views, [this] { m_views.reveal(m_views.solid()); });
    layout()->addWidget(slider);
    return slider;
}

bool HeightControls::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonDblClick) {
        auto* slider = static_cast<QSlider*>(watched);
        slider->setValue(slider->minimum());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void HeightControls::onExplode(bool isOn) {
    const QSignalBlocker blocker(m_spread);
    m_spread->setValue(isOn ? kSpreadSteps : 0);
    m_views.explode(isOn ? 1.0F : 0.0F);
}

void HeightControls::onSpread(int value) {
    m_actions[ActionId::Explode].setChecked(value > 0);
    m_views.setExplode(static_cast<float>(value) / kSpreadSteps);
}

void HeightControls::applyScale() {
    const auto scale = static_cast<float>(m_scale->value());
    const bool isCopper = m_actions[ActionId::ExaggerateCopperHeight].isChecked();
    const bool isOther = m_actions[ActionId::ExaggerateDielectricHeight].isChecked();
    m_views.setZScale({scale * (isCopper ? kCopperScale : 1.0F), scale * (isOther ? kDielectricScale : 1.0F)});
}

void HeightControls::onBoard() {
    if (std::exchange(m_isReadAnew, false)) {
        return;
    }
    for (const ActionId id : {ActionId::ExaggerateCopperHeight, ActionId::ExaggerateDielectricHeight}) {
        m_actions[id].setChecked(false);
    }
    const QSignalBlocker blocker(m_scale);
    m_scale->setValue(1);
    applyScale();
    m_spread->setValue(0);
    onSpread(0);  // a spread on its way ends too
}

QString HeightControls::text() const {
    const auto times = [](float factor) { return QStringLiteral("×%1").arg(static_cast<double>(factor), 0, 'g', 4); };
    QStringList parts;
    if (m_views.exploded() > 0.0F) {
        parts += tr("Explode %1×").arg(static_cast<double>(m_views.exploded()), 0, 'f', 1);
    }
    const render::ZScale& scale = m_views.zScale();
    if (scale.copper == scale.dielectric) {
        parts += scale.copper == 1.0F ? QStringList() : QStringList(tr("Height %1").arg(times(scale.copper)));
    } else {
        parts += tr("Copper %1").arg(times(scale.copper));
        parts += tr("Dielectric %1").arg(times(scale.dielectric));
    }
    return parts.join(QStringLiteral(" · "));
}

void HeightControls::paint(QPainter& painter) const {
    const QString written = text();
    if (written.isEmpty() || m_views.scene() == nullptr) {
        return;
    }
    const QFontMetricsF metrics(painter.font());
    const QRectF box(kMargin, kMargin, metrics.horizontalAdvance(written) + 2 * kPadding, metrics.height() + kPadding);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kGround);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(kInk);
    painter.drawText(box, Qt::AlignCenter, written);
}

}  // namespace ui
