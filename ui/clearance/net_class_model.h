#pragma once

#include <QAbstractTableModel>
#include <string>
#include <vector>

#include "ui/clearance/rule_model.h"

namespace ui {

/// The net classes that rules speak of: name, patterns, and how many nets of the board they fit.
class NetClassModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Nets, Fits, ColumnCount };

    /// Edits the classes of `rules`, which must live longer. `nets`: all names of the board.
    NetClassModel(RuleModel& rules, std::vector<std::string> nets, QObject* parent = nullptr);

    /// A class with a name of its own and no nets.
    void addClass();
    void removeClass(int row);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Patterns stand between commas.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    [[nodiscard]] const model::NetClass& classOf(int row) const;
    [[nodiscard]] std::vector<std::string> netsOf(const model::NetClass& netClass) const;

    RuleModel& m_rules;
    std::vector<std::string> m_nets;
};

}  // namespace ui
