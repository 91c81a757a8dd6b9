#include "ui/measure/measurement_model.h"

#include <utility>

namespace ui {

using model::Measurement;
using model::MeasurementKind;

namespace {

/// Both, or one of them if they are alike.
QString pairText(const std::string& a, const std::string& b, const char* none) {
    const auto text = [none](const std::string& name) {
        return name.empty() ? QString::fromUtf8(none) : QString::fromStdString(name);
    };
    return a == b ? text(a) : QStringLiteral("%1 – %2").arg(text(a), text(b));
}

/// Distances have parts along the axes.
bool hasDeltas(const Measurement& measurement) {
    return measurement.kind == MeasurementKind::Points || measurement.kind == MeasurementKind::Clearance;
}

}  // namespace

QString valueText(const Measurement& measurement) {
    const auto inBoth = [](double nm) { return lengthInBoth(nm, LengthUnit::Millimetre); };
    if (measurement.overlap > 0) {
        return QStringLiteral("overlap %1").arg(inBoth(measurement.overlap));
    }
    switch (measurement.kind) {
        case MeasurementKind::Angle: return angleText(measurement.angleDeg());
        case MeasurementKind::Radius:
            return QStringLiteral("R %1  ⌀ %2")
                .arg(inBoth(measurement.distance()), inBoth(2.0 * measurement.distance()));
        case MeasurementKind::Length: return inBoth(measurement.path->length());
        default: return inBoth(measurement.distance());
    }
}

QStringList partsText(const Measurement& measurement, LengthUnit unit) {
    const auto length = [unit](double nm) { return lengthText(nm, unit); };
    if (hasDeltas(measurement)) {
        const QString plane = QStringLiteral("ΔX %1  ΔY %2").arg(length(measurement.dx()), length(measurement.dy()));
        return {measurement.dz > 0 ? QStringLiteral("%1  ΔZ %2").arg(plane, length(measurement.dz)) : plane};
    }
    QStringList parts;
    if (measurement.path) {
        for (const auto& [layer, onLayer] : measurement.path->perLayer()) {
            parts += QStringLiteral("%1 %2").arg(QString::fromStdString(layer), length(onLayer));
        }
        const std::size_t holes = measurement.path->holeCount;
        parts += holes == 0 ? QStringLiteral("no holes")
                            : QStringLiteral("%1 %2 %3")
                                  .arg(holes)
                                  .arg(holes == 1 ? QStringLiteral("hole") : QStringLiteral("holes"),
                                       length(measurement.path->holeHeight));
    }
    return parts;
}

QStringList remarksText(const Measurement& measurement) {
    QStringList notes;
    for (const std::string& note : measurement.notes) {
        notes += QString::fromStdString(note);
    }
    return notes;
}

QString layersText(const Measurement& measurement) {
    return pairText(measurement.from.layer, measurement.to.layer, "no layer");
}

QString netsText(const Measurement& measurement) {
    return pairText(measurement.from.net, measurement.to.net, "no net");
}

void MeasurementModel::setMeasurements(List measurements) {
    if (measurements.size() != m_measurements.size()) {
        beginResetModel();
        m_measurements = std::move(measurements);
        endResetModel();
    } else if (!measurements.empty()) {
        m_measurements = std::move(measurements);
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

void MeasurementModel::setUnit(LengthUnit unit) {
    m_unit = unit;
    if (!m_measurements.empty()) {
        emit dataChanged(index(0, Value), index(rowCount() - 1, Details));
    }
}

int MeasurementModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_measurements.size());
}

int MeasurementModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString MeasurementModel::textOf(const Measurement& measurement, int column) const {
    const auto delta = [&](double nm) { return hasDeltas(measurement) ? lengthText(nm, m_unit) : QString(); };
    switch (column) {
        case Name: return QString::fromStdString(measurement.name);
        case Kind: return QLatin1String(toString(measurement.kind));
        case Value: return valueText(measurement);
        case DeltaX: return delta(measurement.dx());
        case DeltaY: return delta(measurement.dy());
        case DeltaZ: return delta(measurement.dz);
        case Layers: return layersText(measurement);
        case Nets: return netsText(measurement);
        default: return detailsOf(measurement);
    }
}

QString MeasurementModel::detailsOf(const Measurement& measurement) const {
    const QStringList parts = hasDeltas(measurement) ? QStringList() : partsText(measurement, m_unit);
    return (parts + remarksText(measurement)).join(QStringLiteral("; "));
}

QVariant MeasurementModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const Measurement& measurement = m_measurements[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole: return textOf(measurement, index.column());
        case Qt::ToolTipRole:
            return (QStringList{QStringLiteral("%1: %2, from %3 to %4")
                                    .arg(textOf(measurement, Name), textOf(measurement, Kind),
                                         QString::fromStdString(measurement.from.snap),
                                         QString::fromStdString(measurement.to.snap)),
                                textOf(measurement, Value)} +
                    partsText(measurement, m_unit) + remarksText(measurement))
                .join('\n');
        case Qt::CheckStateRole:
            return index.column() == Name ? QVariant(measurement.isShown ? Qt::Checked : Qt::Unchecked) : QVariant();
        case Qt::TextAlignmentRole:
            return index.column() >= Value && index.column() <= DeltaZ ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                                                       : QVariant();
        default: return {};
    }
}

QVariant MeasurementModel::headerData(int section, Qt::Orientation orientation, int role) const {
    constexpr const char* kTitles[ColumnCount] = {"Name", "Measured", "Value", "ΔX",     "ΔY",
                                                  "ΔZ",   "Layers",   "Nets",  "Details"};
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section < 0 || section >= ColumnCount) {
        return {};
    }
    return QString::fromUtf8(kTitles[section]);
}

Qt::ItemFlags MeasurementModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags plain = QAbstractTableModel::flags(index);
    return index.isValid() && index.column() == Name ? plain | Qt::ItemIsEditable | Qt::ItemIsUserCheckable : plain;
}

bool MeasurementModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.column() != Name) {
        return false;
    }
    if (role == Qt::CheckStateRole) {
        emit shownChanged(index.row(), value.toInt() == Qt::Checked);
        return true;
    }
    const QString name = value.toString().trimmed();
    if (role != Qt::EditRole || name.isEmpty()) {
        return false;
    }
    if (name != data(index, Qt::EditRole).toString()) {
        emit renamed(index.row(), name);
    }
    return true;
}

}  // namespace ui
