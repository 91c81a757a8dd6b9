#include "ui/stackup/stackup_model.h"

#include <QFont>

#include "model/board/stackup.h"
#include "model/session/length_text.h"
#include "ui/common/lengths.h"
#include "ui/layers/layer_model.h"

namespace ui {

namespace {

struct ColumnText {
    const char* heading;
    const char* tip;
};

constexpr ColumnText kColumns[StackupModel::ColumnCount] = {
    {"#", "From the top of the board"},
    {"Layer", "As the job names it; “below TOP” for laminate that the job has no layer for"},
    {"Type", "What the layer is for"},
    {"Thickness",
     "Double-click to set it, for example 35 µm, 0.2 mm, 4 mil or 1 oz; empty it to go back to the job's value"},
    {"From",
     "Where the thickness comes from: read from the job, derived from other values of it, assumed, or set by you"},
    {"Copper", "Weight in ounces per square foot"},
    {"Material", "As the job names it"},
    {"Dk", "Dielectric constant"},
    {"Df", "Loss tangent"},
};

QString sourceText(model::Source source) {
    switch (source) {
        case model::Source::Job: return QStringLiteral("read");
        case model::Source::Derived: return QStringLiteral("derived");
        case model::Source::Assumed: return QStringLiteral("assumed");
        case model::Source::Session: return QStringLiteral("set by you");
    }
    return {};
}

QVariant numberText(const std::optional<double>& value) {
    return value ? QVariant(QString::number(*value, 'g', 4)) : QVariant();
}

QVariant weightText(const model::StackupRow& row) {
    const std::optional<model::CopperWeight> weight = model::copperWeightOf(row);
    return weight ? QVariant(QString::number(weight->oz, 'g', 3) + QStringLiteral(" oz")) : QVariant();
}

/// In both systems, with how to change it.
QString thicknessTip(const model::StackupRow& row) {
    return QStringLiteral("%1, %2\n%3")
        .arg(lengthInBoth(row.thickness, LengthUnit::Millimetre), sourceText(row.source),
             QString::fromUtf8(kColumns[StackupModel::Thickness].tip));
}

QVariant fontOf(model::Source source) {
    QFont font;
    font.setItalic(source == model::Source::Assumed);
    font.setBold(source == model::Source::Session);
    return font;
}

}  // namespace

const model::StackupRow& StackupModel::row(int index) const {
    return m_document->stackup.rows[static_cast<std::size_t>(index)];
}

void StackupModel::setDocument(std::shared_ptr<const model::Document> document) {
    const std::size_t before = m_document ? m_document->stackup.rows.size() : 0;
    const std::size_t after = document ? document->stackup.rows.size() : 0;
    const bool isSame = before == after && before > 0;
    if (!isSame) {
        beginResetModel();
    }
    m_document = std::move(document);
    if (!isSame) {
        endResetModel();
    } else {
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

int StackupModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_document ? 0 : static_cast<int>(m_document->stackup.rows.size());
}

int StackupModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant StackupModel::displayData(int at, int column) const {
    const model::StackupRow& row = this->row(at);
    switch (column) {
        case Order: return at + 1;
        case Name: return QString::fromStdString(row.name);
        case Type: return layerTypeText(row.type);
        case Thickness: return QString::fromStdString(model::session::thicknessText(row.thickness));
        case From: return sourceText(row.source);
        case Weight: return weightText(row);
        case Constant: return numberText(row.material.dielectricConstant);
        case Tangent: return numberText(row.material.lossTangent);
        case MaterialName: return QString::fromStdString(row.material.name);
        default: return {};
    }
}

QVariant StackupModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const bool isThickness = index.column() == Thickness || index.column() == From;
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole: return displayData(index.row(), index.column());
        case Qt::FontRole: return isThickness ? fontOf(row(index.row()).source) : QVariant();
        case Qt::ToolTipRole: return isThickness ? thicknessTip(row(index.row())) : QVariant();
        default: return {};
    }
}

QVariant StackupModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return kColumns[section].heading;
        case Qt::ToolTipRole: return QString::fromUtf8(kColumns[section].tip);
        default: return {};
    }
}

Qt::ItemFlags StackupModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::NoItemFlags;
    }
    const Qt::ItemFlags common = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return index.column() == Thickness ? common | Qt::ItemIsEditable : common;
}

void StackupModel::reset(const std::vector<int>& rows) {
    std::vector<model::ThicknessOverride> changes;
    for (const int at : rows) {
        changes.push_back({row(at).name, 0});
    }
    emit edited(changes);
}

bool StackupModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || index.column() != Thickness || role != Qt::EditRole) {
        return false;
    }
    const model::StackupRow changed = row(index.row());  // a copy: listeners set another document
    const std::string text = value.toString().trimmed().toStdString();
    const bool isCopper = model::copperWeightOf(changed).has_value();
    const base::Result<model::Nm> nm =
        text.empty() ? base::Result<model::Nm>(0) : model::session::parseThickness(text, isCopper);
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
