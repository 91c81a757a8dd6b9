#include "ui/clearance/net_class_model.h"

#include <QStringList>
#include <algorithm>
#include <utility>

namespace ui {

namespace {

struct ColumnText {
    const char* heading;
    const char* tip;
};

constexpr ColumnText kColumns[NetClassModel::ColumnCount] = {
    {"Class", "What rules call these nets"},
    {"Nets", "Names between commas, with * for any text and ? for any letter: VCC*, GND"},
    {"Of this board", "How many nets of the board these are"},
};
constexpr int kMostNamesInTip = 20;

QString textOf(const std::vector<std::string>& patterns) {
    QStringList words;
    for (const std::string& pattern : patterns) {
        words += QString::fromStdString(pattern);
    }
    return words.join(QStringLiteral(", "));
}

std::vector<std::string> patternsOf(const QString& text) {
    std::vector<std::string> patterns;
    for (const QString& word : text.split(',')) {
        if (!word.trimmed().isEmpty()) {
            patterns.push_back(word.trimmed().toStdString());
        }
    }
    return patterns;
}

}  // namespace

NetClassModel::NetClassModel(RuleModel& rules, std::vector<std::string> nets, QObject* parent)
    : QAbstractTableModel(parent), m_rules(rules), m_nets(std::move(nets)) {}

const model::NetClass& NetClassModel::classOf(int row) const {
    return m_rules.rules().classes[static_cast<std::size_t>(row)];
}

std::vector<std::string> NetClassModel::netsOf(const model::NetClass& netClass) const {
    std::vector<std::string> fitting;
    for (const std::string& net : m_nets) {
        if (std::ranges::any_of(netClass.nets, [&](const std::string& p) { return model::fitsWildcard(net, p); })) {
            fitting.push_back(net);
        }
    }
    return fitting;
}

void NetClassModel::addClass() {
    const auto nameOf = [](int number) { return "class " + std::to_string(number); };
    int number = rowCount() + 1;
    while (std::ranges::find(m_rules.rules().classes, nameOf(number), &model::NetClass::name) !=
           m_rules.rules().classes.end()) {
        ++number;
    }
    beginResetModel();
    m_rules.setClass(m_rules.rules().classes.size(), {nameOf(number), {}});
    endResetModel();
}

void NetClassModel::removeClass(int row) {
    beginResetModel();
    m_rules.removeClass(static_cast<std::size_t>(row));
    endResetModel();
}

int NetClassModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rules.rules().classes.size());
}

int NetClassModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant NetClassModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const model::NetClass& netClass = classOf(index.row());
    if (role == Qt::ToolTipRole && index.column() == Fits) {
        std::vector<std::string> nets = netsOf(netClass);
        const bool isMore = nets.size() > kMostNamesInTip;
        nets.resize(std::min<std::size_t>(nets.size(), kMostNamesInTip));
        return textOf(nets) + (isMore ? QStringLiteral(", …") : QString());
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    switch (index.column()) {
        case Name: return QString::fromStdString(netClass.name);
        case Nets: return textOf(netClass.nets);
        case Fits: {
            const std::size_t count = netsOf(netClass).size();
            return count == 1 ? QStringLiteral("1 net") : QStringLiteral("%L1 nets").arg(count);
        }
        default: return {};
    }
}

QVariant NetClassModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return QLatin1String(kColumns[section].heading);
        case Qt::ToolTipRole: return QLatin1String(kColumns[section].tip);
        default: return {};
    }
}

Qt::ItemFlags NetClassModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.column() == Name || index.column() == Nets ? flags | Qt::ItemIsEditable : flags;
}

bool NetClassModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || role != Qt::EditRole || index.column() == Fits) {
        return false;
    }
    model::NetClass netClass = classOf(index.row());
    if (index.column() == Name) {
        netClass.name = value.toString().trimmed().toStdString();
    } else {
        netClass.nets = patternsOf(value.toString());
    }
    if (netClass == classOf(index.row())) {
        return true;
    }
    if (!m_rules.setClass(static_cast<std::size_t>(index.row()), netClass)) {
        return false;
    }
    emit dataChanged(this->index(index.row(), 0), this->index(index.row(), ColumnCount - 1));
    return true;
}

}  // namespace ui
