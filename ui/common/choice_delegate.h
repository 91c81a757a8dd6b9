#pragma once

#include <QStyledItemDelegate>

namespace ui {

/// Cells that are one of a list of names, which their model answers under `role`, are chosen from a box; others are
/// typed.
class ChoiceDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    explicit ChoiceDelegate(int role, QObject* parent = nullptr) : QStyledItemDelegate(parent), m_role(role) {}

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

private:
    int m_role;
};

}  // namespace ui
