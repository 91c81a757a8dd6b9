#include "ui/stackup/stackup_model.h"

#include <algorithm>
#include <numeric>

#include "model/base/thickness_units.h"
#include "model/board/stackup.h"
#include "ui/common/severity_colour.h"
#include "ui/common/thickness_text.h"
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

StackupModel::StackupModel(QObject* parent) : TableModel(columnsFor({}), parent) {}

std::vector<Column> StackupModel::columnsFor(const std::vector<model::Substack>& substacks) {
    std::vector<ui::Column> columns{
        {tr("#"), tr("From the top of the board")},
        {tr("Layer"), tr("As the job names it; “below TOP” for a dielectric that the job has no layer for")},
        {tr("Type"), tr("What the layer is for; core or prepreg where the job says so")},
        {tr("Thickness"), thicknessHint(), kEditable}};
    const QString counted = tr("Solder mask, coverlay, adhesive and stiffener count; paste, silkscreen and ink do not");
    if (substacks.size() < 2 && (substacks.empty() || substacks[0].name.empty())) {
        columns.push_back({tr("Cumulative"), tr("Thickness from the top down to the layer's lower face.\n") + counted});
    } else {
        for (const model::Substack& zone : substacks) {
            const QString name = QString::fromStdString(zone.name);
            columns.push_back({name, tr("Zone %1: thickness from its top down to the layer's lower face; – where it "
                                        "does not have the layer.\n")
                                             .arg(name) +
                                         counted});
        }
    }
    columns.insert(columns.end(),
                   {{tr("From"), tr("Where the thickness comes from: read from the job, derived from other values of "
                                    "it, assumed, or edited by you")},
                    {tr("Copper"), tr("Copper weight in ounces per square foot")},
                    {tr("Dk"), tr("Dielectric constant")},
                    {tr("Df"), tr("Loss tangent")},
                    {tr("Material"), tr("As the job names it")}});
    return columns;
}

QString StackupModel::thicknessHint() {
    return tr(
        "Double-click it or type to set it, for example 35 µm, 0.2 mm, 4 mil or 1 oz; a number alone is in the unit "
        "that is shown; empty it to go back to the job's value");
}

QString StackupModel::sourceText(model::Source source) {
    switch (source) {
        case model::Source::Job: return tr("read");
        case model::Source::Derived: return tr("derived");
        case model::Source::Assumed: return tr("assumed");
        case model::Source::Session: return tr("edited");
    }
    return {};
}

QString StackupModel::typeText(const model::StackupRow& row, model::StackupKind kind) {
    switch (kind) {
        case model::StackupKind::Core: return tr("Core");
        case model::StackupKind::Prepreg: return tr("Prepreg");
        case model::StackupKind::Coverlay: return tr("Coverlay");
        case model::StackupKind::Adhesive: return tr("Adhesive");
        case model::StackupKind::Stiffener: return tr("Stiffener");
        case model::StackupKind::Finish: return tr("Finish");
        default: return layerTypeText(row.type);
    }
}

const model::StackupRow& StackupModel::row(int index) const {
    return m_document->stackup.rows[static_cast<std::size_t>(index)];
}

int StackupModel::rowOf(model::LayerId layer) const {
    for (int index = 0; layer.isValid() && index < layerCount(); ++index) {
        if (row(index).layer == layer) {
            return index;
        }
    }
    return -1;
}

std::pair<StackupModel::Column, std::size_t> StackupModel::fieldOf(int column) const {
    const int behind = std::max(static_cast<int>(m_substacks.size()), 1) - 1;
    if (column <= Cumulative) {
        return {static_cast<Column>(column), 0};
    }
    return column <= Cumulative + behind ? std::pair{Cumulative, static_cast<std::size_t>(column - Cumulative)}
                                         : std::pair{static_cast<Column>(column - behind), std::size_t{0}};
}

int StackupModel::columnOf(Column column) const {
    return column <= Cumulative ? column : column + std::max(static_cast<int>(m_substacks.size()), 1) - 1;
}

void StackupModel::setDocument(std::shared_ptr<const model::Document> document) {
    std::vector<model::Substack> substacks = document ? model::substacksOf(*document) : std::vector<model::Substack>{};
    const bool isSame = m_document && document && document->stackup.rows.size() == m_document->stackup.rows.size() &&
                        std::ranges::equal(substacks, m_substacks, {}, &model::Substack::name, &model::Substack::name);
    if (!isSame) {
        beginResetModel();
        setColumns(columnsFor(substacks));
    }
    m_document = std::move(document);
    m_substacks = std::move(substacks);
    checkAll(unit());
    isSame ? announceChange() : endResetModel();
}

void StackupModel::setUnit(LengthUnit unit) {
    checkAll(unit);
    TableModel::setUnit(unit);
}

void StackupModel::checkAll(LengthUnit unit) {
    m_findings =
        m_document ? model::checkStackup(*m_document, lengthWriter(unit)) : std::vector<model::StackupFinding>{};
}

Qt::ItemFlags StackupModel::flags(const QModelIndex& index) const {
    return isTotal(index.row()) ? TableModel::flags(index) & ~Qt::ItemIsEditable : TableModel::flags(index);
}

Cell StackupModel::cell(int at, int column) const {
    if (isTotal(at)) {
        return totalCell(at, column);
    }
    const model::StackupRow& row = this->row(at);
    const auto [field, substack] = fieldOf(column);
    switch (field) {
        case Order: return {at + 1};
        case Name: return nameCell(at);
        case Type: return {typeText(row, model::kindOf(row, *m_document))};
        case Thickness: return {.text = thicknessText(row.thickness, unit()), .font = fontOf(row.source)};
        case Cumulative: return cumulativeCell(at, substack);
        case From: return {.text = sourceText(row.source), .font = fontOf(row.source)};
        case Weight: return weightOf(row);
        case Constant: return number(row.material.dielectricConstant);
        case Tangent: return number(row.material.lossTangent);
        default: return text(row.material.name);
    }
}

Cell StackupModel::totalCell(int at, int column) const {
    const auto [field, substack] = fieldOf(column);
    const bool isOverall = at > layerCount();
    if (field == Name) {
        return {.text = isOverall ? tr("Overall") : tr("Copper to copper"), .font = boldFont()};
    }
    const bool isAlone = m_substacks.size() == 1;  // then also where thicknesses stand, which is seen sooner
    if (field != Cumulative && !(field == Thickness && isAlone)) {
        return {};
    }
    const model::Substack& part = m_substacks[substack];
    return {.text = heightText(isOverall ? part.overall : part.copperToCopper, unit()), .font = boldFont()};
}

Cell StackupModel::cumulativeCell(int at, std::size_t substack) const {
    const model::Substack& part = m_substacks[substack];
    const auto row = static_cast<std::size_t>(at);
    if (!part.has[row]) {
        return {QStringLiteral("–")};
    }
    const std::optional<model::Nm>& sum = part.cumulative[row];
    return sum ? Cell{heightText(*sum, unit())} : Cell{};
}

Cell StackupModel::nameCell(int at) const {
    Cell cell = text(row(at).name);
    for (const model::StackupFinding& finding : m_findings) {
        const bool isAbout = std::ranges::find(finding.rows, static_cast<std::size_t>(at)) != finding.rows.end();
        if (isAbout && (cell.decoration.isNull() || finding.severity == model::Severity::Warning)) {
            cell.decoration = severityColour(finding.severity);
        }
    }
    return cell;
}

/// What was found about the row; of its thickness, in both systems, how to change it.
QString StackupModel::tip(int at, int column) const {
    if (isTotal(at)) {
        return at > layerCount() ? tr("All layers that count")
                                 : tr("From the upper face of the highest to the lower face of the lowest copper");
    }
    QStringList lines;
    const Column field = fieldOf(column).first;
    if (field == Thickness || field == From) {
        lines += lengthInBoth(row(at).thickness, unit()) + ", " + sourceText(row(at).source);
        lines += thicknessHint();
    }
    for (const model::StackupFinding& finding : m_findings) {
        if (std::ranges::find(finding.rows, static_cast<std::size_t>(at)) != finding.rows.end()) {
            lines += QString::fromStdString(finding.text);
        }
    }
    return lines.join('\n');
}

void StackupModel::reset(const std::vector<int>& rows) {
    std::vector<model::ThicknessOverride> changes;
    for (const int at : rows) {
        if (!isTotal(at)) {
            changes.push_back({row(at).name, 0});
        }
    }
    emit edited(changes);
}

void StackupModel::resetAll() {
    std::vector<int> rows(static_cast<std::size_t>(layerCount()));
    std::iota(rows.begin(), rows.end(), 0);
    reset(rows);
}

/// A bare number is in the unit of what stands there: "200" for "91.44 µm".
std::string StackupModel::withUnit(const QString& text, model::Nm now) const {
    bool isNumber = false;
    QString::fromStdString(model::withDecimalPoint(text.toStdString())).toDouble(&isNumber);
    const QString shown = thicknessText(now, unit());
    return (isNumber ? text + shown.mid(shown.lastIndexOf(QLatin1Char(' '))) : text).toStdString();
}

bool StackupModel::edit(int at, int, const QVariant& value) {
    const model::StackupRow changed = row(at);  // a copy: listeners set another document
    const std::string text = withUnit(value.toString().trimmed(), changed.thickness);
    if (text == thicknessText(changed.thickness, unit()).toStdString()) {
        return true;  // as it is shown, which is rounded in mil and inch: nobody has changed it
    }
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
