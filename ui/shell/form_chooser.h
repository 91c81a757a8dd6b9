#pragma once

#include <QDialog>
#include <vector>

#include "model/formats/registry.h"

class QTreeWidget;

namespace ui {

/// Which of several forms of a board, or of several boards in one folder or archive, is to be opened. The proposed one
/// is chosen first, so that Enter takes it.
class FormChooser : public QDialog {
    Q_OBJECT

public:
    /// `forms`: at least one, the proposed first. `path`: the folder or archive that they lie in.
    FormChooser(const std::filesystem::path& path, std::vector<model::BoardForm> forms, QWidget* parent = nullptr);

    void accept() override;

signals:
    void chosen(const model::BoardForm& form);

private:
    std::vector<model::BoardForm> m_forms;
    QTreeWidget* m_list;
};

}  // namespace ui
