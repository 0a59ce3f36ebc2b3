#include "renderer/volume/cloud/cloud_field.h"

namespace pileus::volume {

std::unique_ptr<const CloudField> cloudField(const CloudParams& params, JobControl& control) {
  switch (params.genus) {
    case Genus::Stratus:
    case Genus::Stratocumulus:
      return stratusField(params);
    case Genus::Cirrus:
      return cirrusField(params);
    case Genus::Classic:
    case Genus::Cumulus:
      break;
  }
  return cumulusField(params, control);
}

}  // namespace pileus::volume
