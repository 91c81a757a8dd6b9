#include "ui/clearance/rule_model.h"

#include <QColor>
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/session/length_text.h"

namespace ui {

namespace {

struct ColumnText {
    const char* heading;
    const char* tip;
};

constexpr ColumnText kColumns[RuleModel::ColumnCount] = {
    {"On", "Whether anything is held against the rule"},
    {"Rule", "What is held against what"},
    {"Kind", "What keeps a distance, or how much must be left"},
    {"Between", "Nets of this class; any net"},
    {"And", "Nets of this class; any net"},
    {"At least", "The least distance that is right; with a unit (100um, 4 mil) or in yours"},
    {"Result", "How many places break the rule"},
};
/// Mid tones, readable on a light and on a dark ground; the word says the same.
constexpr QColor kBroken(0xd9, 0x4a, 0x3d);
constexpr QColor kKept(0x3a, 0x9a, 0x7a);
constexpr model::Nm kCommonGap = 100'000;

QString anyNet() {
    return QStringLiteral("any net");
}

/// None if the text is no length that a rule can ask for.
std::optional<model::Nm> lengthOf(const QString& text, LengthUnit unit) {
    bool isNumber = false;
    const double bare = text.trimmed().toDouble(&isNumber) * nmPer(unit);
    double nm = bare;
    if (!isNumber) {
        const base::Result<base::Nm> length = model::session::parseLength(text.trimmed().toStdString());
        nm = length ? static_cast<double>(*length) : -1.0;
    }
    const bool isLeast = nm >= 0.5 && nm <= static_cast<double>(model::kMostLeast);
    return isLeast ? std::optional(static_cast<model::Nm>(std::lround(nm))) : std::nullopt;
}

}  // namespace

void RuleModel::setRules(model::RuleTable rules) {
    beginResetModel();
    m_rules = std::move(rules);
    m_counts.clear();
    endResetModel();
}

void RuleModel::setCounts(std::vector<std::size_t> counts) {
    m_counts = std::move(counts);
    if (rowCount() > 0) {
        emit dataChanged(index(0, Result), index(rowCount() - 1, Result));
    }
}

void RuleModel::setUnit(LengthUnit unit) {
    m_unit = unit;
    if (rowCount() > 0) {
        emit dataChanged(index(0, Least), index(rowCount() - 1, Least));
    }
}

/// Rows stay what they are, or the whole table is another.
void RuleModel::change(model::RuleTable after) {
    const model::RuleTable before = m_rules;
    if (after.rules.size() != before.rules.size()) {
        setRules(std::move(after));
    } else {
        m_rules = std::move(after);
        m_counts.clear();
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
    emit edited(before);
}

bool RuleModel::refuse(const QString& why) {
    emit refused(why);
    return false;
}

void RuleModel::addRule() {
    model::RuleTable after = m_rules;
    after.rules.push_back({model::RuleKind::CopperToCopper, kCommonGap, {}});
    change(std::move(after));
}

void RuleModel::removeRule(int row) {
    if (m_rules.rules.size() == 1) {
        refuse(QStringLiteral("There must be one rule at least; it can be switched off."));
        return;
    }
    model::RuleTable after = m_rules;
    after.rules.erase(after.rules.begin() + row);
    change(std::move(after));
}

int RuleModel::moveRule(int row, int by) {
    const int to = row + by;
    if (to < 0 || to >= rowCount()) {
        return row;
    }
    model::RuleTable after = m_rules;
    std::swap(after.rules[static_cast<std::size_t>(row)], after.rules[static_cast<std::size_t>(to)]);
    change(std::move(after));
    return to;
}

bool RuleModel::setClass(std::size_t row, const model::NetClass& netClass) {
    const bool isNew = row == m_rules.classes.size();
    if (netClass.name.empty()) {
        return refuse(QStringLiteral("A net class needs a name."));
    }
    const auto known = std::ranges::find(m_rules.classes, netClass.name, &model::NetClass::name);
    if (known != m_rules.classes.end() && static_cast<std::size_t>(known - m_rules.classes.begin()) != row) {
        return refuse(QStringLiteral("There is a net class %1 already.").arg(QString::fromStdString(netClass.name)));
    }
    if (isNew && row == model::kMostNetClasses) {
        return refuse(QStringLiteral("There can be %1 net classes.").arg(model::kMostNetClasses));
    }
    model::RuleTable after = m_rules;
    if (isNew) {
        after.classes.push_back(netClass);
    } else {
        const std::string old = std::exchange(after.classes[row], netClass).name;
        for (model::Rule& rule : after.rules) {
            std::ranges::replace(rule.classes, old, netClass.name);
        }
    }
    change(std::move(after));
    return true;
}

bool RuleModel::removeClass(std::size_t row) {
    const std::string& name = m_rules.classes[row].name;
    const auto user = std::ranges::find_if(
        m_rules.rules, [&](const model::Rule& rule) { return std::ranges::count(rule.classes, name) > 0; });
    if (user != m_rules.rules.end()) {
        return refuse(QStringLiteral("Rule %1 speaks of %2: change or remove it first.")
                          .arg(user - m_rules.rules.begin() + 1)
                          .arg(QString::fromStdString(name)));
    }
    model::RuleTable after = m_rules;
    after.classes.erase(after.classes.begin() + static_cast<std::ptrdiff_t>(row));
    change(std::move(after));
    return true;
}

int RuleModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rules.rules.size());
}

int RuleModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString RuleModel::resultOf(std::size_t row) const {
    if (!m_rules.rules[row].isOn) {
        return QStringLiteral("off");
    }
    if (m_counts.empty()) {
        return QStringLiteral("not checked");
    }
    return m_counts[row] == 0   ? QStringLiteral("pass")
           : m_counts[row] == 1 ? QStringLiteral("FAIL, in 1 place")
                                : QStringLiteral("FAIL, in %L1 places").arg(m_counts[row]);
}

QString RuleModel::textOf(std::size_t row, int column) const {
    const model::Rule& rule = m_rules.rules[row];
    const auto className = [&](std::size_t side) {
        return rule.classes[side].empty() ? anyNet() : QString::fromStdString(rule.classes[side]);
    };
    const bool isOfNets = rule.kind == model::RuleKind::CopperToCopper;
    switch (column) {
        case Title: return QString::fromStdString(model::titleOf(rule));
        case Kind: return QLatin1String(model::nameOf(rule.kind));
        case First: return isOfNets ? className(0) : QString();
        case Second: return isOfNets ? className(1) : QString();
        case Least: return lengthText(static_cast<double>(rule.least), m_unit);
        case Result: return resultOf(row);
        default: return {};
    }
}

QStringList RuleModel::choicesOf(int column) const {
    QStringList choices;
    if (column == Kind) {
        for (std::size_t kind = 0; kind < model::kRuleKindCount; ++kind) {
            choices += QLatin1String(model::nameOf(static_cast<model::RuleKind>(kind)));
        }
    } else if (column == First || column == Second) {
        choices += anyNet();
        for (const model::NetClass& netClass : m_rules.classes) {
            choices += QString::fromStdString(netClass.name);
        }
    }
    return choices;
}

bool RuleModel::hasClasses(const QModelIndex& index) const {
    return m_rules.rules[static_cast<std::size_t>(index.row())].kind == model::RuleKind::CopperToCopper;
}

QVariant RuleModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const auto row = static_cast<std::size_t>(index.row());
    const bool isOn = m_rules.rules[row].isOn;
    switch (role) {
        case Qt::CheckStateRole:
            return index.column() == On ? QVariant(isOn ? Qt::Checked : Qt::Unchecked) : QVariant();
        case Qt::ForegroundRole:
            return index.column() == Result && !m_counts.empty() && isOn ? (m_counts[row] == 0 ? kKept : kBroken)
                                                                         : QVariant();
        case Qt::DisplayRole:
        case Qt::EditRole: return textOf(row, index.column());
        case ChoicesRole: return choicesOf(index.column());
        default: return {};
    }
}

QVariant RuleModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return QLatin1String(kColumns[section].heading);
        case Qt::ToolTipRole: return QLatin1String(kColumns[section].tip);
        default: return {};
    }
}

Qt::ItemFlags RuleModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid()) {
        return flags;
    }
    switch (index.column()) {
        case On: return flags | Qt::ItemIsUserCheckable;
        case Kind:
        case Least: return flags | Qt::ItemIsEditable;
        case First:
        case Second: return hasClasses(index) ? flags | Qt::ItemIsEditable : flags;
        default: return flags;
    }
}

/// False if the value is none for this column.
bool RuleModel::edit(model::Rule& rule, int column, const QVariant& value) {
    const QString text = value.toString();
    switch (column) {
        case On: rule.isOn = value.value<Qt::CheckState>() == Qt::Checked; return true;
        case Kind: {
            const std::optional<model::RuleKind> kind = model::ruleKindOf(text.toStdString());
            rule.kind = kind.value_or(rule.kind);
            rule.classes = rule.kind == model::RuleKind::CopperToCopper ? rule.classes : decltype(rule.classes){};
            return kind.has_value();
        }
        case First:
        case Second:
            rule.classes[column == First ? 0 : 1] = text == anyNet() ? std::string() : text.toStdString();
            return choicesOf(column).contains(text);
        case Least: {
            const std::optional<model::Nm> least = lengthOf(text, m_unit);
            rule.least = least.value_or(rule.least);
            return least || refuse(QStringLiteral("%1 is no distance: 100um, 4 mil, …").arg(text));
        }
        default: return false;
    }
}

bool RuleModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const int wanted = index.column() == On ? Qt::CheckStateRole : Qt::EditRole;
    if (!index.isValid() || role != wanted || (flags(index) & (Qt::ItemIsEditable | Qt::ItemIsUserCheckable)) == 0) {
        return false;
    }
    if (index.column() == Least && value.toString() == data(index, Qt::EditRole).toString()) {
        return true;  // what is shown is rounded
    }
    model::RuleTable after = m_rules;
    if (!edit(after.rules[static_cast<std::size_t>(index.row())], index.column(), value)) {
        return false;
    }
    if (!(after == m_rules)) {
        change(std::move(after));
    }
    return true;
}

}  // namespace ui
