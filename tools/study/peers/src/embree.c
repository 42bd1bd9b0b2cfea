/* Builds a mesh and casts rays at it one by one, following Embree's manual. */
#include <math.h>
#include <string.h>
#if EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

struct mesh {
    RTCDevice device;
    RTCScene scene;
};

void pinhole_embree_build(struct mesh *mesh, const float *corners, unsigned corner_count,
                          const unsigned *triangles, unsigned triangle_count) {
    mesh->device = rtcNewDevice("threads=1");
    mesh->scene = rtcNewScene(mesh->device);
    rtcSetSceneFlags(mesh->scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(mesh->scene, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(mesh->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *to = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                        3 * sizeof(float), corner_count);
    memcpy(to, corners, 3 * sizeof(float) * corner_count);
    unsigned *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                                RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
                                                triangle_count);
    memcpy(indices, triangles, 3 * sizeof(unsigned) * triangle_count);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(mesh->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(mesh->scene);
}

void pinhole_embree_cast(const struct mesh *mesh, const float (*rays)[6], unsigned count,
                         float *t) {
#if EMBREE == 3
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
#endif
    for (unsigned at = 0; at < count; at++) {
        const float *ray = rays[at];
        struct RTCRayHit asked = {
            .ray = {.org_x = ray[0], .org_y = ray[1], .org_z = ray[2],
                    .dir_x = ray[3], .dir_y = ray[4], .dir_z = ray[5],
                    .tnear = 0, .tfar = INFINITY, .mask = -1},
            .hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .instID = {RTC_INVALID_GEOMETRY_ID}},
        };
#if EMBREE == 3
        rtcIntersect1(mesh->scene, &context, &asked);
#else
        rtcIntersect1(mesh->scene, &asked, 0);
#endif
        t[at] = asked.hit.geomID == RTC_INVALID_GEOMETRY_ID ? INFINITY : asked.ray.tfar;
    }
}

void pinhole_embree_release(struct mesh *mesh) {
    rtcReleaseScene(mesh->scene);
    rtcReleaseDevice(mesh->device);
}
