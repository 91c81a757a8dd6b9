#include "ui/measure/measurement_model.h"

#include "ui/common/texts.h"

namespace ui {

using model::Measurement;
using model::MeasurementKind;

namespace {

/// Both, or one of them if they are alike.
QString pairText(const std::string& a, const std::string& b, const QString& none) {
    const auto text = [&](const std::string& name) { return name.empty() ? none : QString::fromStdString(name); };
    return a == b ? text(a) : QStringLiteral("%1 – %2").arg(text(a), text(b));
}

/// "track of GND": a value that holds between two elements must not read as one that holds between their nets.
QString elementText(const model::MeasuredEnd& end) {
    if (end.item == model::kBoardEdgeItem) {
        return QString::fromStdString(end.item);
    }
    const QString net = end.net.empty() ? MeasurementModel::tr("no net") : QString::fromStdString(end.net);
    return end.item.empty() ? net : MeasurementModel::tr("%1 of %2").arg(QString::fromStdString(end.item), net);
}

/// Distances have parts along the axes.
bool hasDeltas(const Measurement& measurement) {
    return measurement.kind == MeasurementKind::Points || measurement.kind == MeasurementKind::Clearance ||
           measurement.kind == MeasurementKind::Spacing || measurement.kind == MeasurementKind::Ring;
}

}  // namespace

QString valueText(const Measurement& measurement, LengthUnit unit) {
    const auto inBoth = [unit](double nm) { return fixedLengthInBoth(nm, unit); };
    if (measurement.overlap > 0) {
        return MeasurementModel::tr("overlap %1").arg(inBoth(measurement.overlap));
    }
    switch (measurement.kind) {
        case MeasurementKind::Angle: return angleText(measurement.angleDeg());
        case MeasurementKind::Radius:
            return QStringLiteral("R %1  ⌀ %2")
                .arg(inBoth(measurement.distance()), inBoth(2.0 * measurement.distance()));
        case MeasurementKind::Length: return inBoth(measurement.path->length());
        case MeasurementKind::Ring: return MeasurementModel::tr("annular ring %1").arg(inBoth(measurement.value()));
        default: return inBoth(measurement.value());
    }
}

QStringList partsText(const Measurement& measurement, LengthUnit unit) {
    const auto length = [unit](double nm) { return fixedLengthText(nm, unit); };
    if (hasDeltas(measurement)) {
        const QString plane = QStringLiteral("ΔX %1  ΔY %2").arg(length(measurement.dx()), length(measurement.dy()));
        if (measurement.dz <= 0) {
            return {plane};
        }
        const QString inSpace = QStringLiteral("%1  ΔZ %2").arg(plane, length(measurement.dz));
        return measurement.isPlanar
                   ? QStringList{inSpace, MeasurementModel::tr("in space %1").arg(length(measurement.distance()))}
                   : QStringList{inSpace};
    }
    QStringList parts;
    if (measurement.path) {
        for (const auto& [layer, onLayer] : measurement.path->perLayer()) {
            parts += QStringLiteral("%1 %2").arg(QString::fromStdString(layer), length(onLayer));
        }
        const std::size_t holes = measurement.path->holeCount;
        parts += holes == 0 ? MeasurementModel::tr("no holes")
                 : holes == 1
                     ? MeasurementModel::tr("1 hole %1").arg(length(measurement.path->holeHeight))
                     : MeasurementModel::tr("%1 holes %2").arg(holes).arg(length(measurement.path->holeHeight));
    }
    return parts;
}

QString layersText(const Measurement& measurement) {
    return pairText(measurement.from.layer, measurement.to.layer, MeasurementModel::tr("no layer"));
}

QString netsText(const Measurement& measurement) {
    if (!measurement.from.item.empty() || !measurement.to.item.empty()) {
        return QStringLiteral("%1 – %2").arg(elementText(measurement.from), elementText(measurement.to));
    }
    return pairText(measurement.from.net, measurement.to.net, MeasurementModel::tr("no net"));
}

MeasurementModel::MeasurementModel(QObject* parent)
    : TableModel({{tr("Name"), {}, kEditable | kCheck},
                  {tr("Measured"), {}},
                  {tr("Value"), {}, kNumber},
                  {tr("ΔX"), {}, kNumber},
                  {tr("ΔY"), {}, kNumber},
                  {tr("ΔZ"), {}, kNumber},
                  {tr("Layers"), {}},
                  {tr("Elements and nets"), {}},
                  {tr("Details"), {}}},
                 parent) {}

QString MeasurementModel::textOf(const Measurement& measurement, int column) const {
    const auto delta = [&](double nm) { return hasDeltas(measurement) ? fixedLengthText(nm, unit()) : QString(); };
    switch (column) {
        case Name: return QString::fromStdString(measurement.name);
        case Kind: return QLatin1String(toString(measurement.kind));
        case Value: return valueText(measurement, unit());
        case DeltaX: return delta(measurement.dx());
        case DeltaY: return delta(measurement.dy());
        case DeltaZ: return delta(measurement.dz);
        case Layers: return layersText(measurement);
        case Nets: return netsText(measurement);
        default: return detailsOf(measurement);
    }
}

QString MeasurementModel::detailsOf(const Measurement& measurement) const {
    const QStringList parts = hasDeltas(measurement) ? QStringList() : partsText(measurement, unit());
    return (parts + textsOf(measurement.notes)).join(QStringLiteral("; "));
}

Cell MeasurementModel::cell(int row, int column) const {
    const Measurement& measurement = m_measurements[static_cast<std::size_t>(row)];
    Cell cell{textOf(measurement, column)};
    if (column == Name) {
        cell.isChecked = measurement.isShown;
    }
    return cell;
}

QString MeasurementModel::tip(int row, int) const {
    const Measurement& measurement = m_measurements[static_cast<std::size_t>(row)];
    const QString ends =
        tr("%1: %2, from %3 to %4")
            .arg(textOf(measurement, Name), textOf(measurement, Kind), QString::fromStdString(measurement.from.snap),
                 QString::fromStdString(measurement.to.snap));
    return (QStringList{ends, textOf(measurement, Value)} + partsText(measurement, unit()) + textsOf(measurement.notes))
        .join('\n');
}

bool MeasurementModel::check(int row, int, bool isChecked) {
    emit shownChanged(row, isChecked);
    return true;
}

bool MeasurementModel::edit(int row, int, const QVariant& value) {
    const QString name = value.toString().trimmed();
    if (!name.isEmpty() && name != cell(row, Name).text.toString()) {
        emit renamed(row, name);
    }
    return !name.isEmpty();
}

}  // namespace ui
