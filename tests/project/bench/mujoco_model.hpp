#pragma once
/// @file
/// MuJoCo's models, from text in its own language.

#include <mujoco/mujoco.h>

#include <cstring>
#include <memory>
#include <string>

#include "tumble/core/require.hpp"

namespace tumble::bench {

/// @throws std::invalid_argument saying what MuJoCo's compiler says
inline mjModel* load(const std::string& xml) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(xml.size()) + 1);
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), "scene.xml")], xml.c_str(),
              xml.size() + 1);
  char error[1000] = "";
  mjModel* model = mj_loadXML("scene.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  require(model != nullptr, "MuJoCo: ", error);
  return model;
}

}  // namespace tumble::bench
