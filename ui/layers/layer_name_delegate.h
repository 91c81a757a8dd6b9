#pragma once

#include <QFontMetrics>
#include <QStringList>

#include "ui/common/cell_delegate.h"

namespace ui {

/// What is shown of a layer's name in so many pixels: without its middle, as names differ at their ends. Where another
/// of `all` would look the same, from where the two differ: "…TOP sold…" of "SOLDERMASK-TOP solder mask" beside
/// "SOLDERMASK-BOTTOM solder mask", "…tom solder mask" of "bottom solder mask" beside "bottom solder mask solder mask".
[[nodiscard]] QString shortName(const QString& name, const QStringList& all, const QFontMetrics& letters, int width);

/// Names in the table of layers.
class LayerNameDelegate : public CellDelegate {
    Q_OBJECT

public:
    using CellDelegate::CellDelegate;

    void setNames(QStringList names) { m_names = std::move(names); }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
    QStringList m_names;
};

}  // namespace ui
