#pragma once

#include <QRegularExpression>
#include <QString>
#include <map>
#include <vector>

/// A STEP file as tests read it: entities by number, knowing nothing of how ours are written.
struct StepEntity {
    QString name;  ///< empty for entities of several types
    QString body;
    std::vector<int> references;
};

inline std::map<int, StepEntity> entitiesOf(const QString& text) {
    static const QRegularExpression line("^#(\\d+)=([A-Z0-9_]*)(.*);$", QRegularExpression::MultilineOption);
    static const QRegularExpression reference("#(\\d+)");
    std::map<int, StepEntity> entities;
    for (auto found = line.globalMatch(text); found.hasNext();) {
        const auto match = found.next();
        StepEntity& entity = entities[match.captured(1).toInt()];
        entity.name = match.captured(2);
        entity.body = match.captured(3);
        for (auto at = reference.globalMatch(entity.body); at.hasNext();) {
            entity.references.push_back(at.next().captured(1).toInt());
        }
    }
    return entities;
}

inline int countOf(const std::map<int, StepEntity>& entities, const QString& name) {
    int count = 0;
    for (const auto& [id, entity] : entities) {
        count += entity.name == name ? 1 : 0;
    }
    return count;
}

/// Empty, or what is wrong: a reference to nothing, or an edge that is not in two faces in opposite directions.
inline QString faultOf(const std::map<int, StepEntity>& entities) {
    std::map<int, int> uses;
    std::map<int, int> turns;
    for (const auto& [id, entity] : entities) {
        for (const int reference : entity.references) {
            if (!entities.contains(reference)) {
                return QString("#%1 refers to #%2, which is not there").arg(id).arg(reference);
            }
        }
        if (entity.name != "FACE_OUTER_BOUND" && entity.name != "FACE_BOUND") {
            continue;
        }
        const int sense = entity.body.endsWith(",.T.)") ? 1 : -1;
        for (const int oriented : entities.at(entity.references.front()).references) {
            const StepEntity& use = entities.at(oriented);
            const int edge = use.references.front();
            ++uses[edge];
            turns[edge] += sense * (use.body.endsWith(",.T.)") ? 1 : -1);
        }
    }
    for (const auto& [edge, count] : uses) {
        if (count != 2 || turns[edge] != 0) {
            return QString("edge #%1 is in %2 faces, in directions that add up to %3")
                .arg(edge)
                .arg(count)
                .arg(turns[edge]);
        }
    }
    return {};
}
