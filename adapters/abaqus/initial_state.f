C     SPDX-License-Identifier: BSD-3-Clause
C     Initial state of level ground for Abaqus/Standard: SIGINI and
C     SDVINI, to be compiled with the job. Edit GROUND. They are
C     no part of the library: a host would pick them up there.
C       *INITIAL CONDITIONS, TYPE=STRESS, USER
C       *INITIAL CONDITIONS, TYPE=SOLUTION, USER

C     Effective stress at rest at a point, compression positive, and
C     what the sand there remembers. Units are those of the model.
      SUBROUTINE GROUND(COORDS,NCRDS,IV,SV,SH,E,HV)
      IMPLICIT NONE
      INTEGER NCRDS,IV
      DOUBLE PRECISION COORDS(NCRDS),SV,SH,E,HV,P
C     Level of the surface, load on it, effective unit weight, K0
      DOUBLE PRECISION TOP,LOAD,GAMMA,RKZERO
      PARAMETER (TOP=0.D0,LOAD=1.D0,GAMMA=10.D0,RKZERO=0.45D0)
C     Void ratio at zero pressure, h_s and n of PROPS
      DOUBLE PRECISION EZERO,HS,RN
      PARAMETER (EZERO=0.65D0,HS=1.6D6,RN=0.19D0)
C     R of PROPS, and the share of it that sedimentation has left in h
      DOUBLE PRECISION R,RHO
      PARAMETER (R=1.D-4,RHO=1.D0)
C     The vertical: axis 2 in the plane, 3 in space
      IV = NCRDS
      SV = LOAD + GAMMA*MAX(TOP - COORDS(IV),0.D0)
      SH = RKZERO*SV
      P = (SV + 2.D0*SH)/3.D0
      E = EZERO*EXP(-(3.D0*P/HS)**RN)
      HV = -RHO*R
      END

      SUBROUTINE SIGINI(SIGMA,COORDS,NTENS,NCRDS,NOEL,NPT,LAYER,
     1                  KSPT,LREBAR,NAMES)
      IMPLICIT NONE
      INTEGER NTENS,NCRDS,NOEL,NPT,LAYER,KSPT,LREBAR,I,IV
      DOUBLE PRECISION SIGMA(NTENS),COORDS(NCRDS),SV,SH,E,HV
      CHARACTER*80 NAMES(2)
      CALL GROUND(COORDS,NCRDS,IV,SV,SH,E,HV)
      DO I = 1, NTENS
        SIGMA(I) = 0.D0
        IF (I.LE.3) SIGMA(I) = -SH
      END DO
      SIGMA(IV) = -SV
      END

      SUBROUTINE SDVINI(STATEV,COORDS,NSTATV,NCRDS,NOEL,NPT,LAYER,
     1                  KSPT)
      IMPLICIT NONE
      INTEGER NSTATV,NCRDS,NOEL,NPT,LAYER,KSPT,I,IV
      DOUBLE PRECISION STATEV(NSTATV),COORDS(NCRDS),SV,SH,E,HV
C     Places of h and e: classic layout 1 and 7, second layout 2 and 1
      INTEGER IH,IE
      PARAMETER (IH=1,IE=7)
      CALL GROUND(COORDS,NCRDS,IV,SV,SH,E,HV)
      DO I = 1, NSTATV
        STATEV(I) = 0.D0
      END DO
      STATEV(IE) = E
      STATEV(IH+IV-1) = HV
      END
