#pragma once

#include <QStringList>
#include <vector>

#include "model/measure/measurement.h"
#include "ui/common/table_model.h"

namespace ui {

/// In the unit, and in brackets in the other: "overlap 0.12 mm (4.7 mil)", "0.25 mm (9.84 mil)", "45°",
/// "R 0.3 mm (11.81 mil)  ⌀ 0.6 mm (23.62 mil)".
[[nodiscard]] QString valueText(const model::Measurement& measurement, LengthUnit unit);
/// What the value is made of, in lines: "ΔX 0.25 mm  ΔY 0 mm  ΔZ 1.2 mm", without ΔZ where the layers are at one
/// height; of a length what lies on each layer and in holes: "TOP 12 mm", "2 holes 3.2 mm".
[[nodiscard]] QStringList partsText(const model::Measurement& measurement, LengthUnit unit);
/// "TOP – BOTTOM", or one name if both ends are on one layer.
[[nodiscard]] QString layersText(const model::Measurement& measurement);
/// The same of nets; between two elements "track of P3_3V – pad U1.7 of GND".
[[nodiscard]] QString netsText(const model::Measurement& measurement);

/// What the user has measured, in the order it was measured. The box before a name says whether it is drawn. Names and
/// boxes can be edited; whoever listens sets the changed list.
class MeasurementModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Name, Kind, Value, DeltaX, DeltaY, DeltaZ, Layers, Nets, Details };
    using List = std::vector<model::Measurement>;

    explicit MeasurementModel(QObject* parent = nullptr);

    void setMeasurements(List measurements) { replace(m_measurements, std::move(measurements)); }
    [[nodiscard]] const List& measurements() const { return m_measurements; }

signals:
    void renamed(int row, const QString& name);
    void shownChanged(int row, bool isShown);

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_measurements.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;
    bool edit(int row, int column, const QVariant& value) override;
    bool check(int row, int column, bool isChecked) override;
    [[nodiscard]] QString textOf(const model::Measurement& measurement, int column) const;
    [[nodiscard]] QString detailsOf(const model::Measurement& measurement) const;

    List m_measurements;
};

}  // namespace ui
