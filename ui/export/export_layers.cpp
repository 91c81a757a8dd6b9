#include "ui/export/export_layers.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <tuple>

#include "model/board/layers.h"
#include "model/export/solids/solid_choice.h"

namespace ui {

namespace {

constexpr int kRow = Qt::UserRole;  ///< of the layer on the board

bool hasElements(const model::Layer& layer) {
    return layer.elements.count > 0 || std::ranges::any_of(layer.countsWithCopies, [](auto n) { return n > 0; });
}

std::size_t rowOf(const QListWidgetItem& item) {
    return item.data(kRow).toULongLong();
}

bool isOn(const QListWidgetItem& item) {
    return item.checkState() == Qt::Checked;
}

/// With a frame that shows on any ground.
QPixmap swatch(const QColor& colour) {
    QPixmap picture(12, 12);
    picture.fill(Qt::gray);
    QPainter(&picture).fillRect(1, 1, 10, 10, colour);
    return picture;
}

}  // namespace

ExportLayers::ExportLayers(const LayerModel& layers, QWidget* parent)
    : QGroupBox(tr("Layers"), parent), m_model(layers), m_list(new QListWidget) {
    m_list->setObjectName(QStringLiteral("exportLayers"));
    m_list->setAccessibleName(tr("Layers"));
    const std::vector<QColor> colours = layers.colours();
    for (std::size_t row = 0; row < colours.size(); ++row) {
        const model::Layer& layer = layers.document()->layers[row];
        if (hasElements(layer)) {
            auto* item = new QListWidgetItem(swatch(colours[row]), QString::fromStdString(layer.name), m_list);
            item->setToolTip(layerTypeText(layer.type));
            item->setData(kRow, static_cast<qulonglong>(row));
            item->setCheckState(Qt::Unchecked);
        }
    }
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_list, 1);
    column->addWidget(buttons());
    connect(m_list, &QListWidget::itemChanged, this, &ExportLayers::changed);
}

QWidget* ExportLayers::buttons() {
    using Rule = std::function<bool(std::size_t)>;
    const auto copper = model::layersOf(*m_model.document(), model::LayerPreset::Copper);
    const std::vector<LayerAppearance> styles = m_model.effectiveStyles();
    const auto isSolid = [this](std::size_t row) { return model::isSolidLayer(m_model.document()->layers[row]); };
    const std::tuple<QString, QString, Rule> rows[] = {
        {tr("&Board"),
         tr("What a finished board consists of: copper, plated holes, substrate, solder mask, print, bodies"), isSolid},
        {tr("&All"), tr("Every layer that anything is on"), [](std::size_t) { return true; }},
        {tr("&Visible"), tr("What the views show now"), [styles](std::size_t row) { return styles[row].isVisible; }},
        {tr("&Copper"), tr("The copper layers, without holes"), [copper](std::size_t row) { return copper[row]; }}};
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins({});
    for (const auto& [text, tip, rule] : rows) {
        auto* button = new QPushButton(text);
        button->setToolTip(tip);
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, [this, rule = rule] { check(rule); });
        layout->addWidget(button);
    }
    return row;
}

template <class Rule>
void ExportLayers::check(const Rule& isChecked) {
    {
        const QSignalBlocker blocker(m_list);
        for (int i = 0; i < m_list->count(); ++i) {
            QListWidgetItem& item = *m_list->item(i);
            item.setCheckState(isChecked(rowOf(item)) ? Qt::Checked : Qt::Unchecked);
        }
    }
    m_list->viewport()->update();
    emit changed();
}

std::vector<model::LayerId> ExportLayers::layers() const {
    std::vector<model::LayerId> layers;
    for (int i = 0; i < m_list->count(); ++i) {
        if (isOn(*m_list->item(i))) {
            layers.emplace_back(rowOf(*m_list->item(i)));
        }
    }
    return layers;
}

void ExportLayers::restore(const Settings& settings) {
    const QStringList on = settings.exportChoice(QStringLiteral("layers"), {}).toStringList();
    const QStringList off = settings.exportChoice(QStringLiteral("layersLeftOut"), {}).toStringList();
    check([&](std::size_t row) {
        const model::Layer& layer = m_model.document()->layers[row];
        const QString name = QString::fromStdString(layer.name);
        return on.contains(name) || (!off.contains(name) && model::isSolidLayer(layer));
    });
}

void ExportLayers::remember(Settings& settings) const {
    QStringList on;
    QStringList off;
    for (int i = 0; i < m_list->count(); ++i) {
        (isOn(*m_list->item(i)) ? on : off) += m_list->item(i)->text();
    }
    settings.setExportChoice(QStringLiteral("layers"), on);
    settings.setExportChoice(QStringLiteral("layersLeftOut"), off);
}

}  // namespace ui
