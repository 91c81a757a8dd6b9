#include "ui/stackup/stackup_model.h"

#include "model/base/thickness_units.h"
#include "model/board/stackup.h"
#include "ui/layers/layer_model.h"

namespace ui {

namespace {

Cell number(const std::optional<double>& value) {
    return value ? Cell{QString::number(*value, 'g', 4)} : Cell{};
}

Cell weightOf(const model::StackupRow& row) {
    const std::optional<model::CopperWeight> weight = model::copperWeightOf(row);
    return weight ? Cell{QString::number(weight->oz, 'g', 3) + QStringLiteral(" oz")} : Cell{};
}

QFont fontOf(model::Source source) {
    QFont font;
    font.setItalic(source == model::Source::Assumed);
    font.setBold(source == model::Source::Session);
    return font;
}

}  // namespace

StackupModel::StackupModel(QObject* parent)
    : TableModel({{tr("#"), tr("From the top of the board")},
                  {tr("Layer"), tr("As the job names it; “below TOP” for a dielectric that the job has no layer for")},
                  {tr("Type"), tr("What the layer is for")},
                  {tr("Thickness"), thicknessHint(), kEditable},
                  {tr("From"), tr("Where the thickness comes from: read from the job, derived from other values of it, "
                                  "assumed, or set by you")},
                  {tr("Copper"), tr("Copper weight in ounces per square foot")},
                  {tr("Material"), tr("As the job names it")},
                  {tr("Dk"), tr("Dielectric constant")},
                  {tr("Df"), tr("Loss tangent")}},
                 parent) {}

QString StackupModel::thicknessHint() {
    return tr(
        "Double-click to set it, for example 35 µm, 0.2 mm, 4 mil or 1 oz; empty it to go back to the job's "
        "value");
}

QString StackupModel::sourceText(model::Source source) const {
    switch (source) {
        case model::Source::Job: return tr("read");
        case model::Source::Derived: return tr("derived");
        case model::Source::Assumed: return tr("assumed");
        case model::Source::Session: return tr("set by you");
    }
    return {};
}

const model::StackupRow& StackupModel::row(int index) const {
    return m_document->stackup.rows[static_cast<std::size_t>(index)];
}

void StackupModel::setDocument(std::shared_ptr<const model::Document> document) {
    const bool isSame = m_document && document && document->stackup.rows.size() == m_document->stackup.rows.size();
    if (!isSame) {
        beginResetModel();
    }
    m_document = std::move(document);
    isSame ? announceChange() : endResetModel();
}

Cell StackupModel::cell(int at, int column) const {
    const model::StackupRow& row = this->row(at);
    switch (column) {
        case Order: return {at + 1};
        case Name: return text(row.name);
        case Type: return {layerTypeText(row.type)};
        case Thickness:
            return {.text = QString::fromStdString(model::thicknessText(row.thickness)), .font = fontOf(row.source)};
        case From: return {.text = sourceText(row.source), .font = fontOf(row.source)};
        case Weight: return weightOf(row);
        case Constant: return number(row.material.dielectricConstant);
        case Tangent: return number(row.material.lossTangent);
        default: return text(row.material.name);
    }
}

/// In both systems, with how to change it.
QString StackupModel::tip(int at, int column) const {
    const model::StackupRow& row = this->row(at);
    return column != Thickness && column != From
               ? QString()
               : QStringLiteral("%1, %2\n%3")
                     .arg(lengthInBoth(row.thickness, LengthUnit::Millimetre), sourceText(row.source), thicknessHint());
}

void StackupModel::reset(const std::vector<int>& rows) {
    std::vector<model::ThicknessOverride> changes;
    for (const int at : rows) {
        changes.push_back({row(at).name, 0});
    }
    emit edited(changes);
}

bool StackupModel::edit(int at, int, const QVariant& value) {
    const model::StackupRow changed = row(at);  // a copy: listeners set another document
    const std::string text = value.toString().trimmed().toStdString();
    const bool isCopper = model::copperWeightOf(changed).has_value();
    const base::Result<model::Nm> nm =
        text.empty() ? base::Result<model::Nm>(0) : model::parseThickness(text, isCopper);
    if (!nm) {
        emit refused(QString::fromStdString(nm.error().text));
        return false;
    }
    if (*nm != changed.thickness) {
        emit edited({{changed.name, *nm}});
    }
    return true;
}

}  // namespace ui
