/* tests/cli: the OBJ reader's meshes: scale, sharing of vertices, normals. Its errors are tested
 * through etch-sim (meshes.sh). */
#include "ports/host/obj.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/harness/harness.h"

void suite_obj(void);

static struct etch_error error;

/* Reads a mesh from a text; false if that fails. */
static bool read_text(struct etch_obj *obj, const char *text)
{
    const char *folder = getenv("TMPDIR");
    char path[512];
    FILE *file;
    bool ok;

    (void)snprintf(path, sizeof path, "%s/etch-obj-test-%p.obj", folder != NULL ? folder : "/tmp",
                   (void *)obj);
    file = fopen(path, "wb");
    if (!CHECK(file != NULL))
        return false;
    (void)fputs(text, file);
    (void)fclose(file);
    ok = etch_obj_open(obj, path, &error);
    (void)remove(path);
    return ok;
}

static void check_position(const struct etch_obj *obj, int vertex, int x, int y, int z)
{
    CHECK_EQ(obj->positions[vertex * 3], x);
    CHECK_EQ(obj->positions[vertex * 3 + 1], y);
    CHECK_EQ(obj->positions[vertex * 3 + 2], z);
}

static void check_normal(const struct etch_obj *obj, int vertex, int x, int y, int z)
{
    CHECK_EQ(obj->normals[vertex * 3], x);
    CHECK_EQ(obj->normals[vertex * 3 + 1], y);
    CHECK_EQ(obj->normals[vertex * 3 + 2], z);
}

/* The largest coordinate that a face uses decides; v that no face uses does not. */
static void scale_is_the_greatest_that_fits(void)
{
    static const struct {
        const char *size;
        int scale, bits, largest;
    } cases[] = {{"1", 14, 14, 16384},       {"-1.99", 14, 14, 32604}, {"2", 13, 13, 16384},
                 {"1.99996", 14, 14, 32767}, {"32767", 0, 0, 32767},   {"32767.4", 0, 0, 32767},
                 {"32767.5", -1, 0, 16384},  {"0.25", 16, 15, 16384},  {"1e9", -15, 0, 30518},
                 {"0.0000001", 31, 15, 215}};

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct etch_obj obj;
        char text[200];

        (void)snprintf(text, sizeof text, "v %s 0 0\nv 0 0 0\nv 0 0 0\nv 1e6 0 0\nf 1 2 3\n",
                       cases[i].size);
        if (!CHECK(read_text(&obj, text)))
            continue;
        CHECK_EQ(obj.scale, cases[i].scale);
        CHECK_EQ(obj.mesh.bits, cases[i].bits);
        CHECK_EQ(obj.mesh.extent, cases[i].largest);
        etch_obj_close(&obj);
    }
}

/* Two faces of a roof share an edge: two of its corners are one vertex each. */
static void shared_corners_are_one_vertex(void)
{
    struct etch_obj obj;

    if (!CHECK(read_text(&obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 7 7 7\nf 1 2 3 4\n")))
        return;
    CHECK_EQ(obj.mesh.vertex_count, 4);
    CHECK_EQ(obj.mesh.triangle_count, 2);
    for (int i = 0; i < 6; i++) {
        static const uint16_t expected[] = {0, 1, 2, 0, 2, 3};
        CHECK_EQ(obj.indices[i], expected[i]);
    }
    check_position(&obj, 2, 16384, 16384, 0);
    check_normal(&obj, 0, 0, 0, 127);
    etch_obj_close(&obj);
}

/* A corner of a v with another vn is a vertex of its own. */
static void other_normals_are_other_vertices(void)
{
    struct etch_obj obj;

    if (!CHECK(read_text(&obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 9\nvn -1 0 1e-30\n"
                               "f 1//1 2//1 3//1\nf 1//2 3//2 4//2\nf 1 2 3\nf 1//1 2//1 3//1\n")))
        return;
    CHECK_EQ(obj.mesh.vertex_count, 9);
    check_normal(&obj, obj.indices[0], 0, 0, 127);
    check_normal(&obj, obj.indices[3], -127, 0, 0);
    check_position(&obj, obj.indices[3], 0, 0, 0);
    CHECK(obj.indices[9] == obj.indices[0] && obj.indices[6] != obj.indices[0]);
    etch_obj_close(&obj);
}

/* Averages are weighted by area: 12 towards z, 16 towards x and nothing else make 3 : 4. */
static void missing_normals_are_averaged(void)
{
    struct etch_obj obj;

    if (!CHECK(read_text(&obj, "v 0 0 0\nv 4 0 0\nv 0 3 0\nv 0 4 0\nv 0 0 4\n"
                               "f 1 2 3\nf 1 4 5\n")))
        return;
    check_normal(&obj, 0, 102, 0, 76); /* 127 * 4/5 = 101.6, 127 * 3/5 = 76.2 */
    check_normal(&obj, obj.indices[1], 0, 0, 127);
    check_normal(&obj, obj.indices[4], 127, 0, 0);
    etch_obj_close(&obj);
}

/* Every normal of the teapot has length 127 to a unit, and its mesh is in range. */
static void the_teapot_is_a_mesh(void)
{
    struct etch_obj obj;

    if (!CHECK(etch_obj_open(&obj, "tests/scenes/teapot.obj", &error)))
        return;
    CHECK_EQ(obj.mesh.triangle_count, 2256);
    CHECK_EQ(obj.mesh.vertex_count, 1177);
    for (int i = 0; i < obj.mesh.vertex_count; i++) {
        const int8_t *n = obj.normals + (size_t)i * 3;
        const int length = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];

        CHECK(length >= 126 * 126 && length <= 128 * 128);
    }
    for (int i = 0; i < obj.mesh.triangle_count * 3; i++)
        CHECK(obj.indices[i] < obj.mesh.vertex_count);
    etch_obj_close(&obj);
}

/* 65535 triangles are a mesh, one more is an error. */
static void the_limit_is_checked(void)
{
    static char text[400000];
    struct etch_obj obj;
    size_t n = (size_t)snprintf(text, sizeof text, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1");

    for (int i = 0; i < 65536; i++)
        n += (size_t)snprintf(text + n, sizeof text - n, " %d", 1 + i % 3);
    if (CHECK(read_text(&obj, text))) {
        CHECK_EQ(obj.mesh.triangle_count, 65535);
        etch_obj_close(&obj);
    }
    (void)snprintf(text + n, sizeof text - n, " 1\n");
    CHECK(!read_text(&obj, text));
    CHECK(strstr(error.text, ":4: more than 65535 triangles") != NULL);
}

/* vt with as many bits as fit, t from the top; corners that differ in vt alone are two vertices. */
static void texture_coordinates_are_kept(void)
{
    struct etch_obj obj;

    if (!read_text(&obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0.25\nvt 0.5\n"
                         "f 1/1 2/2 3/3\nf 1/2 2/2 3/3\n"))
        return;
    CHECK_EQ(obj.mesh.vertex_count, 4);
    CHECK_EQ(obj.coordinate_bits, 14);
    CHECK_EQ(obj.coordinates[0], 0);
    CHECK_EQ(obj.coordinates[1], 16384);
    CHECK_EQ(obj.coordinates[2], 16384);
    CHECK_EQ(obj.coordinates[3], 12288);
    CHECK_EQ(obj.coordinates[4], 8192);
    CHECK_EQ(obj.coordinates[5], 16384);
    CHECK_EQ(obj.coordinates[6], 16384);
    etch_obj_close(&obj);
    if (!read_text(&obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 -3\nf 1/1 2/1 3\n"))
        return;
    CHECK(obj.coordinates == NULL);
    etch_obj_close(&obj);
    if (!read_text(&obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 -3\nf 1/1 2/1 3/1\n"))
        return;
    CHECK_EQ(obj.coordinate_bits, 12);
    CHECK_EQ(obj.coordinates[1], 4 * 4096);
    etch_obj_close(&obj);
}

void suite_obj(void)
{
    RUN(scale_is_the_greatest_that_fits);
    RUN(shared_corners_are_one_vertex);
    RUN(other_normals_are_other_vertices);
    RUN(missing_normals_are_averaged);
    RUN(the_teapot_is_a_mesh);
    RUN(the_limit_is_checked);
    RUN(texture_coordinates_are_kept);
}
