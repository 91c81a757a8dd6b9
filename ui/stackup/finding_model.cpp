#include "ui/stackup/finding_model.h"

#include "ui/common/severity_colour.h"

namespace ui {

FindingModel::FindingModel(QObject* parent)
    : TableModel({{tr("Check"), tr("What the numbers of the stackup contradict; click to select the layers")}},
                 parent) {}

void FindingModel::setFindings(std::vector<model::StackupFinding> findings) {
    beginResetModel();
    m_findings = std::move(findings);
    endResetModel();
}

Cell FindingModel::cell(int row, int) const {
    return {.text = QString::fromStdString(finding(row).text), .decoration = severityColour(finding(row).severity)};
}

QString FindingModel::tip(int row, int) const {
    return QString::fromStdString(finding(row).text);
}

}  // namespace ui
