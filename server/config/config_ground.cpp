#include "server/config/config_ground.hpp"

#include "server/config/field_json.hpp"
#include "server/exercise/definition/def_fields.hpp"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <string_view>

namespace windlass::config {

namespace {

using Json = nlohmann::json;

/// Of each soil, in the order of physics::Soil; "O" coral, "X" mixed.
constexpr std::string_view kSoilLetters = "MSCGROX";

/// Neighbours may not lie steeper to each other than this: 72 degrees.
constexpr double kSteepest = 3;

/// Rows stand from north to south in a file, from south to north in a GroundDef.
template <class Row, class Take>
void each_row(const Json& rows, const Take& take) {
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        take(row->template get<Row>());
}

Json rows_of(const physics::GroundDef& def, const auto& list, auto row, const auto& entry) {
    Json rows = Json::array();
    if (list.empty()) return rows;
    for (int r = def.rows - 1; r >= 0; --r) {
        auto one = row;
        for (int c = 0; c < def.columns; ++c)
            one.push_back(entry(list[static_cast<std::size_t>(r * def.columns + c)]));
        rows.push_back(one);
    }
    return rows;
}

} // namespace

void read_ground(const Json& environment, physics::EnvironmentDef& def) {
    if (!environment.contains("ground")) return;
    const Json& ground = environment.at("ground");
    physics::GroundDef laid;
    FieldReader reader(ground);
    exercise::visit_fields(reader, laid);
    const Json heights = ground.value("heights", Json::array()), soils = ground.value("soils", Json::array());
    laid.rows = static_cast<int>(std::max(heights.size(), soils.size()));
    each_row<std::vector<double>>(heights, [&](const std::vector<double>& row) {
        laid.columns = static_cast<int>(row.size());
        laid.heights.insert(laid.heights.end(), row.begin(), row.end());
    });
    each_row<std::string>(soils, [&](const std::string& row) {
        laid.columns = static_cast<int>(row.size());
        for (const char letter : row)
            laid.soils.push_back(static_cast<physics::Soil>(kSoilLetters.find(letter)));
    });
    def.ground = nullptr;
    if (laid.slope != 0 || laid.rows > 0) lay_ground(def, laid);
}

Json ground_to_json(const physics::EnvironmentDef& def) {
    physics::GroundDef laid = def.ground ? def.ground->def() : physics::GroundDef{};
    Json ground = Json::object();
    FieldWriter writer(ground);
    exercise::visit_fields(writer, laid);
    ground["heights"] =
        rows_of(laid, laid.heights, std::vector<double>{}, [](double height) { return height; });
    ground["soils"] = rows_of(laid, laid.soils, std::string{}, [](physics::Soil soil) {
        return kSoilLetters[static_cast<std::size_t>(soil)];
    });
    return ground;
}

std::vector<std::string> grid_faults(const Json& document) {
    const Json::json_pointer at("/environment/ground");
    if (!document.contains(at)) return {};
    const Json& ground = document.at(at);
    std::vector<std::string> faults;
    const auto size = [](const Json& row) {
        return row.is_string() ? row.get_ref<const std::string&>().size() : row.size();
    };
    std::size_t columns = 0;
    for (const char* list : {"heights", "soils"}) {
        const Json rows = ground.value(list, Json::array());
        for (std::size_t r = 0; r < rows.size(); ++r) {
            if (columns == 0) columns = size(rows[r]);
            if (size(rows[r]) != columns)
                faults.push_back(fmt::format("{}/{}/{}: {} points is not allowed: {}, as in the first row",
                                             at.to_string(), list, r, size(rows[r]), columns));
        }
    }
    const std::size_t heights = ground.value("heights", Json::array()).size(),
                      soils = ground.value("soils", Json::array()).size();
    if (heights > 0 && soils > 0 && heights != soils)
        faults.push_back(fmt::format("{}/soils: {} rows is not allowed: {}, as heights has", at.to_string(),
                                     soils, heights));
    return faults;
}

std::vector<std::string> ground_faults(const physics::EnvironmentDef& def) {
    std::vector<std::string> faults;
    if (!def.ground || def.ground->def().heights.empty()) return faults;
    const physics::GroundDef& laid = def.ground->def();
    const auto height = [&](int r, int c) {
        return laid.heights[static_cast<std::size_t>(r * laid.columns + c)];
    };
    const double max = kSteepest * laid.spacing;
    for (int r = 0; r < laid.rows; ++r)
        for (int c = 0; c < laid.columns; ++c)
            for (const auto& [row, column] : {std::pair(r, c + 1), std::pair(r + 1, c)})
                if (row < laid.rows && column < laid.columns &&
                    std::abs(height(row, column) - height(r, c)) > max)
                    faults.push_back(fmt::format(
                        "/environment/ground/heights/{}/{}: {} is not allowed: within {} m of its neighbour, "
                        "{}: three times the spacing",
                        laid.rows - 1 - row, column, height(row, column), max, height(r, c)));
    return faults;
}

} // namespace windlass::config
