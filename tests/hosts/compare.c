/* SPDX-License-Identifier: BSD-3-Clause
 * compare REFERENCE HOST: lines `case stress_11 stress_22 void_ratio pore_pressure` of both files agree
 * within 1e-6 of the stress, and prints by how much. A number that is not finite agrees with nothing. */
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CASES = 4, NUMBERS = 4 };

static int read(const char* path, char names[CASES][16], double numbers[CASES][NUMBERS]) {
    FILE* file = fopen(path, "r");
    int i;
    if (!file) return 0;
    for (i = 0; i < CASES; ++i) {
        double* x = numbers[i];
        if (fscanf(file, "%15s %lf %lf %lf %lf", names[i], &x[0], &x[1], &x[2], &x[3]) != 5) break;
    }
    fclose(file);
    return i == CASES;
}

int main(int argc, char** argv) {
    char names[2][CASES][16];
    double numbers[2][CASES][NUMBERS];
    int i, j, bad = 0;
    if (argc != 3 || !read(argv[1], names[0], numbers[0]) || !read(argv[2], names[1], numbers[1])) {
        fprintf(stderr, "compare: needs two files of four cases\n");
        return 2;
    }
    for (i = 0; i < CASES; ++i) {
        const double *ours = numbers[0][i], *theirs = numbers[1][i];
        const double size[NUMBERS] = {fabs(ours[0]), fabs(ours[0]), ours[2], fabs(ours[0])};
        double largest = 0.0;
        for (j = 0; j < NUMBERS; ++j) {
            const double difference = fabs(theirs[j] - ours[j]) / size[j];
            if (!isfinite(difference)) {
                printf("%-10s %g instead of %g\n", names[0][i], theirs[j], ours[j]);
                return 1;
            }
            if (difference > largest) largest = difference;
        }
        printf("%-10s %.1e\n", names[0][i], largest);
        if (strcmp(names[0][i], names[1][i]) != 0 || !(largest <= 1e-6)) bad = 1;
    }
    return bad;
}
