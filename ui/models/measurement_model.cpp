#include "ui/models/measurement_model.h"

#include <utility>

namespace ui::models {

using model::session::Measurement;

namespace {

/// Both, or one of them if they are alike.
QString pairText(const std::string& a, const std::string& b, const char* none) {
    const auto text = [none](const std::string& name) {
        return name.empty() ? QString::fromUtf8(none) : QString::fromStdString(name);
    };
    return a == b ? text(a) : QStringLiteral("%1 – %2").arg(text(a), text(b));
}

}  // namespace

QString valueText(const Measurement& measurement) {
    if (measurement.overlap > 0) {
        return QStringLiteral("overlap %1").arg(lengthInBoth(measurement.overlap, LengthUnit::Millimetre));
    }
    return lengthInBoth(measurement.distance(), LengthUnit::Millimetre);
}

QString partsText(const Measurement& measurement, LengthUnit unit) {
    const QString plane =
        QStringLiteral("ΔX %1  ΔY %2").arg(lengthText(measurement.dx(), unit), lengthText(measurement.dy(), unit));
    return measurement.dz > 0 ? QStringLiteral("%1  ΔZ %2").arg(plane, lengthText(measurement.dz, unit)) : plane;
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
        emit dataChanged(index(0, Distance), index(rowCount() - 1, DeltaZ));
    }
}

int MeasurementModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_measurements.size());
}

int MeasurementModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString MeasurementModel::textOf(const Measurement& measurement, int column) const {
    switch (column) {
        case Name: return QString::fromStdString(measurement.name);
        case Distance: return valueText(measurement);
        case DeltaX: return lengthText(measurement.dx(), m_unit);
        case DeltaY: return lengthText(measurement.dy(), m_unit);
        case DeltaZ: return lengthText(measurement.dz, m_unit);
        case Layers: return layersText(measurement);
        default: return netsText(measurement);
    }
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
            return QStringLiteral("%1\n%2, from %3 to %4")
                .arg(textOf(measurement, Name),
                     measurement.isGap ? QStringLiteral("edge to edge") : QStringLiteral("point to point"),
                     QString::fromStdString(measurement.from.snap), QString::fromStdString(measurement.to.snap));
        case Qt::CheckStateRole:
            return index.column() == Name ? QVariant(measurement.isShown ? Qt::Checked : Qt::Unchecked) : QVariant();
        case Qt::TextAlignmentRole:
            return index.column() >= Distance && index.column() <= DeltaZ ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                                                          : QVariant();
        default: return {};
    }
}

QVariant MeasurementModel::headerData(int section, Qt::Orientation orientation, int role) const {
    constexpr const char* kTitles[ColumnCount] = {"Name", "Distance", "ΔX", "ΔY", "ΔZ", "Layers", "Nets"};
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

}  // namespace ui::models
