#include "ui/clearance/net_class_model.h"

#include <algorithm>
#include <utility>

#include "model/text/wildcard.h"
#include "ui/common/texts.h"

namespace ui {

namespace {

constexpr int kMostNamesInTip = 20;

QString textOf(const std::vector<std::string>& patterns) {
    return textsOf(patterns).join(QStringLiteral(", "));
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
    : TableModel(
          {{tr("Class"), tr("What rules call these nets"), kEditable},
           {tr("Nets"), tr("Names between commas, with * for any text and ? for any letter: VCC*, GND"), kEditable},
           {tr("Of this board"), tr("How many nets of the board these are")}},
          parent),
      m_rules(rules),
      m_nets(std::move(nets)) {
    // Other rules bring their own classes. Those that are added or removed here leave the rules as many as they were.
    connect(&rules, &QAbstractItemModel::modelAboutToBeReset, this, [this] { beginResetModel(); });
    connect(&rules, &QAbstractItemModel::modelReset, this, [this] { endResetModel(); });
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
    if (row < 0 || row >= rowCount()) {
        return;
    }
    beginResetModel();
    m_rules.removeClass(static_cast<std::size_t>(row));
    endResetModel();
}

Cell NetClassModel::cell(int row, int column) const {
    switch (column) {
        case Name: return text(classOf(row).name);
        case Nets: return {textOf(classOf(row).nets)};
        default: {
            const std::size_t fitting = netsOf(classOf(row)).size();
            return {fitting == 1 ? tr("1 net") : tr("%L1 nets").arg(fitting)};
        }
    }
}

QString NetClassModel::tip(int row, int column) const {
    if (column != Fits) {
        return {};
    }
    std::vector<std::string> nets = netsOf(classOf(row));
    const bool isMore = nets.size() > kMostNamesInTip;
    nets.resize(std::min<std::size_t>(nets.size(), kMostNamesInTip));
    return textOf(nets) + (isMore ? QStringLiteral(", …") : QString());
}

bool NetClassModel::edit(int row, int column, const QVariant& value) {
    model::NetClass netClass = classOf(row);
    if (column == Name) {
        netClass.name = value.toString().trimmed().toStdString();
    } else {
        netClass.nets = patternsOf(value.toString());
    }
    if (netClass == classOf(row)) {
        return true;
    }
    if (!m_rules.setClass(static_cast<std::size_t>(row), netClass)) {
        return false;
    }
    announceChange();
    return true;
}

}  // namespace ui
