#include "studio/app/body_models.h"

#include <QCoreApplication>
#include <QFile>

#include "core/project/project_file.h"

namespace kumite::studio {

const std::vector<NamedBodyModel>& broughtBodyModels() {
    static const std::vector<NamedBodyModel> models = [] {
        std::vector<NamedBodyModel> found = {
            {QCoreApplication::translate("kumite", "Male means (de Leva 1996)"), deLevaMale()}};
        QFile female(QStringLiteral(":/body_models/de_leva_female.json"));
        if (female.open(QIODevice::ReadOnly)) {
            const QByteArray text = female.readAll();
            found.push_back({QCoreApplication::translate("kumite", "Female means (de Leva 1996)"),
                             parseBodyModel(std::string_view(text.data(),
                                                             static_cast<std::size_t>(text.size())),
                                            "de_leva_female.json")});
        }
        return found;
    }();
    return models;
}

}  // namespace kumite::studio
