#pragma once

#include <QWidget>

#include "ui/nets/net_check_model.h"

class QLabel;
class QLineEdit;

namespace ui {

class ActionSet;
class TableView;

/// Opens, shorts and floating copper. A click on a row, or Enter, requests its location.
class NetCheckPanel : public QWidget {
    Q_OBJECT

public:
    NetCheckPanel(NetCheckModel& model, const ActionSet& actions, QWidget* parent = nullptr);

    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] QLineEdit& filterEdit() { return *m_filterEdit; }
    [[nodiscard]] QString summary() const;

signals:
    void chosen(const NetCheckModel::Finding& finding);

private:
    TableView* m_table;
    QLineEdit* m_filterEdit;
    QLabel* m_summary;
};

}  // namespace ui
