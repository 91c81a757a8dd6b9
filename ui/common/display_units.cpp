#include "ui/common/display_units.h"

#include <QLocale>
#include <algorithm>
#include <array>

#include "model/text/formatting.h"

namespace ui {

namespace {

struct Unit {
    const char* name;
    double nm;
    int digits;  ///< behind the point: steps of 0.1 to 0.25 µm
};

constexpr std::array<Unit, 3> kUnits{
    {{"mm", base::kNmPerMm, 4}, {"mil", base::kNmPerMil, 2}, {"in", base::kNmPerInch, 5}}};

const Unit& of(LengthUnit unit) {
    return kUnits[static_cast<std::size_t>(unit)];
}

QString fixed(double nm, LengthUnit unit) {
    return QString::fromStdString(model::fixedText(nm / of(unit).nm, of(unit).digits));
}

QString withoutZerosAtTheEnd(QString text) {
    while (text.contains('.') && text.endsWith('0')) {
        text.chop(1);
    }
    return text.endsWith('.') ? text.chopped(1) : text;
}

/// What a length is said in beside the user's unit.
LengthUnit otherSystem(LengthUnit unit) {
    return unit == LengthUnit::Millimetre ? LengthUnit::Mil : LengthUnit::Millimetre;
}

}  // namespace

const char* unitName(LengthUnit unit) {
    return of(unit).name;
}

LengthUnit unitNamed(const std::string& name) {
    const auto* const at =
        std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& unit) { return name == unit.name; });
    return at == kUnits.end() ? LengthUnit::Millimetre : static_cast<LengthUnit>(at - kUnits.begin());
}

LengthUnit nextUnit(LengthUnit unit) {
    return static_cast<LengthUnit>((static_cast<std::size_t>(unit) + 1) % kUnits.size());
}

double nmPer(LengthUnit unit) {
    return of(unit).nm;
}

QString lengthText(double nm, LengthUnit unit) {
    return QStringLiteral("%1 %2").arg(withoutZerosAtTheEnd(fixed(nm, unit)), QLatin1String(of(unit).name));
}

QString fixedLengthText(double nm, LengthUnit unit) {
    return QStringLiteral("%1 %2").arg(fixed(nm, unit), QLatin1String(of(unit).name));
}

QString fixedLengthInBoth(double nm, LengthUnit unit) {
    return QStringLiteral("%1 (%2)").arg(fixedLengthText(nm, unit), fixedLengthText(nm, otherSystem(unit)));
}

QString lengthInBoth(double nm, LengthUnit unit) {
    return QStringLiteral("%1 (%2)").arg(lengthText(nm, unit), lengthText(nm, otherSystem(unit)));
}

QString positionText(double x, double y, LengthUnit unit) {
    return QStringLiteral("%1, %2 %3").arg(fixed(x, unit), fixed(y, unit), QLatin1String(of(unit).name));
}

QString angleText(double degrees) {
    constexpr int kDigits = 4;
    return QStringLiteral("%1°").arg(withoutZerosAtTheEnd(QString::fromStdString(model::fixedText(degrees, kDigits))));
}

QString areaText(double squareNm, LengthUnit unit) {
    // Square mils are too small to read; mil users think in square inches here.
    const LengthUnit base = unit == LengthUnit::Millimetre ? unit : LengthUnit::Inch;
    const double value = squareNm / (nmPer(base) * nmPer(base));
    return QStringLiteral("%1 %2²").arg(QLocale::c().toString(value, 'g', 5), QLatin1String(of(base).name));
}

void setNumberFormat() {
    QLocale::setDefault(QLocale(QLocale::English));
}

}  // namespace ui
