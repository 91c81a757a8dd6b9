#include "model/session/measurement.h"

#include <cmath>

#include "model/base/units.h"
#include "model/export_text.h"

namespace model::session {

double Measurement::distance() const {
    return std::hypot(dx(), dy(), dz);
}

std::string measurementsCsv(const std::vector<Measurement>& measurements) {
    std::string csv =
        "name,step,kind,distance mm,distance mil,dx mm,dy mm,dz mm,overlap mm,layer a,layer b,net a,net b,x mm on a,"
        "y mm on a,x mm on b,y mm on b\n";
    for (const Measurement& m : measurements) {
        const auto mm = [](double nm) { return formatted(",%.6f", base::toMm(nm)); };
        csv += csvField(m.name) + "," + csvField(m.step) + (m.isGap ? ",edge to edge" : ",point to point") +
               mm(m.distance()) + formatted(",%.4f", m.distance() / base::kNmPerMil) + mm(m.dx()) + mm(m.dy()) +
               mm(m.dz) + mm(m.overlap);
        for (const std::string* text : {&m.from.layer, &m.to.layer, &m.from.net, &m.to.net}) {
            csv += "," + csvField(*text);
        }
        csv += mm(m.from.x) + mm(m.from.y) + mm(m.to.x) + mm(m.to.y) + "\n";
    }
    return csv;
}

}  // namespace model::session
